// SPDX-License-Identifier: GPL-3.0-or-later
// Included once per instruction set. Noise of affine forms: value and slope at the centre, with what second
// derivatives can add from there (NoiseBounds).
#if defined(ISOSCOPE_EVALUATE_AFFINE_NOISE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOSCOPE_EVALUATE_AFFINE_NOISE_INL
#undef ISOSCOPE_EVALUATE_AFFINE_NOISE_INL
#else
#define ISOSCOPE_EVALUATE_AFFINE_NOISE_INL
#endif

#include <hwy/highway.h>

#include "core/evaluate/algebra/affine_number-inl.h"
#include "core/evaluate/algebra/noise-inl.h"
#include "core/numeric/noise_bounds.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

/// More than the roundings of a noise amount to, relative to sizes about 1.
constexpr double noiseRoundings = 1e-14;

/// How far pieces reach along the axes, rounded up where it matters: the sums of the three ways, and of their
/// squares. Infinite where a coordinate is not known, or beyond the lattice. `error` is the sum of the
/// coordinates' errors, `axis` how far their forms reach.
struct NoiseReaches {
    HWY_ALIGN double sum[batchLanes];
    HWY_ALIGN double squares[batchLanes];
    HWY_ALIGN double error[batchLanes];
    HWY_ALIGN double axis[3][batchLanes];
};

/// Vectors, as bits, with lanes of which something is asked.
struct NoiseNeeds {
    std::uint64_t lines = 0;      ///< the noise along thin pieces
    std::uint64_t gradients = 0;  ///< of others
};

/// A piece of a line in the space of a noise with these bounds. Coordinates of gradient noise are rounded at
/// a distance of 10^7 from where they are; that is part of their error (`shifted`). With `ground`, y is 0.
template <bool shifted, bool ground>
class NoisePiece {
  public:
    static_assert(!(shifted && ground));
    static constexpr NoiseBounds bounds = shifted ? gradientNoiseBounds : latticeNoiseBounds;

    HWY_INLINE NoisePiece(const AffineNumber& x, const AffineNumber& y, const AffineNumber& z)
        : x_(x), y_(y), z_(z) {
        sum_ = squares_ = error_ = zeroVector();
        Vector extent = zeroVector();
        take(x_, extent);
        if constexpr (!ground) take(y_, extent);
        take(z_, extent);
        // Noise takes coordinates beyond its lattice as 0.
        const Mask usable = hn::Lt(extent, constantVector(2147483647.0));
        sum_ = hn::IfThenElse(usable, sum_, constantVector(unlimited));
        squares_ = hn::IfThenElse(usable, squares_, constantVector(unlimited));
    }
    /// The same again; only where the coordinates are what they were then.
    HWY_INLINE NoisePiece(const AffineNumber& x, const AffineNumber& y, const AffineNumber& z,
                          const NoiseReaches& reaches, std::size_t i)
        : x_(x),
          y_(y),
          z_(z),
          sum_(hn::Load(Doubles(), reaches.sum + i)),
          squares_(hn::Load(Doubles(), reaches.squares + i)),
          error_(hn::Load(Doubles(), reaches.error + i)) {
        static_assert(!shifted);
    }

    HWY_INLINE void keep(NoiseReaches& reaches, std::size_t i) const {
        hn::Store(sum_, Doubles(), reaches.sum + i);
        hn::Store(squares_, Doubles(), reaches.squares + i);
        if constexpr (shifted) return;
        hn::Store(error_, Doubles(), reaches.error + i);
        hn::Store(reachAlong(x_), Doubles(), reaches.axis[0] + i);
        if constexpr (!ground) hn::Store(reachAlong(y_), Doubles(), reaches.axis[1] + i);
        hn::Store(reachAlong(z_), Doubles(), reaches.axis[2] + i);
    }

    /// Lanes with known coordinates on the lattice where the noise cannot get further than `limit` from its
    /// value at the centre, by the bounds on its slope.
    HWY_INLINE Mask within(double limit) const {
        const double steepest = bounds.lipschitz * (1 + noiseRoundings) / limit;
        return hn::Or(hn::Lt(sum_, constantVector(limit / bounds.slope)),
                      hn::Lt(hn::Mul(squares_, constantVector(steepest * steepest)), constantVector(1)));
    }

    /// Lanes whose pieces are lines but for very little.
    HWY_INLINE Mask isThin() const { return hn::Le(error_, hn::Mul(squares_, constantVector(1.0 / 16))); }

    /// The noise along a thin piece from its value and derivatives along the line.
    HWY_INLINE AffineNumber developed(const Vector value, Vector slope, Vector bendAlong,
                                      Vector outside) const {
        const Vector length = lengthOf();
        // What the errors of the coordinates change, by the gradient and by the second derivatives.
        const Vector beside = hn::Mul(error_, hn::MulAdd(length, constantVector(3 * bounds.curvature),
                                                         constantVector(bounds.lipschitz)));
        const Vector quarter = hn::Mul(bendAlong, constantVector(0.25));
        const Vector third = hn::Mul(hn::Mul(squares_, length), constantVector(latticeThirdDerivative / 6));
        const Vector size = hn::Abs(quarter);
        const Vector beyond =
            hn::Mul(hn::MulAdd(squares_, constantVector(0.5 * bounds.curvature), hn::Add(size, size)),
                    hn::Mul(outside, outside));
        const Vector curved = hn::Add(hn::Add(size, third), beyond), straight = bend();
        const Mask curves = hn::Lt(curved, straight);
        const Vector error = hn::Add(hn::IfThenElse(curves, curved, straight), beside);
        return kept({hn::Add(value, hn::IfThenElseZero(curves, quarter)), slope, error}, value, length);
    }

    /// The noise along the piece from its value and derivatives at the centre.
    HWY_INLINE AffineNumber developed(const NoiseSample& noise) const {
        Vector slope = hn::Mul(noise.z, z_.b), error = hn::MulAdd(hn::Abs(noise.z), z_.e, bend());
        if constexpr (!ground) {
            slope = hn::MulAdd(noise.y, y_.b, slope);
            error = hn::MulAdd(hn::Abs(noise.y), y_.e, error);
        }
        slope = hn::MulAdd(noise.x, x_.b, slope);
        error = hn::MulAdd(hn::Abs(noise.x), x_.e, error);
        return kept({noise.value, slope, error}, noise.value, lengthOf());
    }

  private:
    HWY_INLINE Vector lengthOf() const {
        return hn::Mul(hn::Sqrt(squares_), constantVector(1 + noiseRoundings));
    }
    static HWY_INLINE Vector reachAlong(const AffineNumber& p) { return hn::Add(hn::Abs(p.b), hn::Abs(p.e)); }

    /// A line, or the value in the middle alone where that says hardly less.
    HWY_INLINE AffineNumber kept(const AffineNumber& line, Vector value, Vector length) const {
        const Vector flat = hn::Min(hn::Mul(sum_, constantVector(bounds.slope)),
                                    hn::Mul(length, constantVector(bounds.lipschitz)));
        const Vector rounding =
            hn::Mul(hn::Add(hn::Add(flat, line.e), constantVector(1)), constantVector(noiseRoundings));
        // A slope is worth its name when it leaves open half of what the bound on the slope does.
        const Mask useful = hn::Le(line.e, half(flat));
        // No branch here or below: what comes so late is not foreseen, and to wait for it costs more.
        return {hn::IfThenElse(useful, line.a, value), hn::IfThenElseZero(useful, line.b),
                hn::Add(hn::IfThenElse(useful, line.e, flat), rounding)};
    }

    HWY_INLINE void take(AffineNumber& p, Vector& extent) {
        const Vector size = hn::Abs(p.a);
        // What is not known, or undefined, reaches infinitely far, or is not a number.
        const Vector radius = hn::Mul(hn::Add(hn::Abs(p.b), hn::Abs(p.e)), constantVector(inflation));
        Vector reach = hn::MulAdd(size, constantVector(1e-16), radius);
        const Vector farthest = hn::Add(size, reach);
        extent = hn::Add(extent, farthest);
        if constexpr (shifted) {
            // At the centre and at the point that is asked for: half a unit in the last place each.
            const Vector rounding =
                hn::Mul(hn::Add(farthest, constantVector(10000001)), constantVector(2.3e-16));
            p.e = hn::Add(p.e, rounding);
            reach = hn::Add(reach, rounding);
        } else {
            error_ = hn::Add(error_, hn::Abs(p.e));
        }
        sum_ = hn::Add(sum_, reach);
        squares_ = hn::MulAdd(reach, reach, squares_);
    }

    /// How far the noise can get from its tangent at the centre, coordinates without error.
    HWY_INLINE Vector bend() const {
        const Vector mixed = hn::MulSub(sum_, sum_, squares_);
        const Vector separate = hn::MulAdd(squares_, constantVector(0.5 * bounds.bend),
                                           hn::Mul(mixed, constantVector(0.5 * bounds.twist)));
        Vector curvature = constantVector(0.5 * (ground ? latticePlaneCurvature : bounds.curvature));
        if constexpr (!shifted && !ground) {
            // As in noise(x, 0, z).
            const Mask flat = hn::And(isExact(y_), hn::Eq(hn::Round(y_.a), y_.a));
            curvature = hn::IfThenElse(flat, constantVector(0.5 * latticePlaneCurvature), curvature);
        }
        return hn::Min(separate, hn::Mul(squares_, curvature));
    }

    AffineNumber x_, y_, z_;
    Vector sum_, squares_;  ///< of the reaches, rounded up where it matters
    Vector error_;          ///< sum of the errors; not of a shifted piece
};

/// min(1, max(0, p)). Only bounds matter: what leaves [0, 1] on one side is moved inside.
HWY_INLINE AffineNumber clippedToUnit(const AffineNumber& p) {
    const Vector zero = zeroVector(), one = constantVector(1);
    const VectorRange range = rangeOf(p);
    const Mask inside = hn::And(hn::Ge(range.low, zero), hn::Le(range.high, one));
    const Vector low = hn::Min(hn::Max(range.low, zero), one), high = hn::Min(hn::Max(range.high, zero), one);
    const Vector center = half(hn::Add(low, high));
    const Vector error = hn::IfThenElseZero(
        hn::Lt(low, high), hn::Add(half(hn::Sub(high, low)), constantVector(noiseRoundings)));
    return chooseNumber(inside, p, {center, zero, error});
}

HWY_INLINE AffineNumber anywhereInUnit() { return {constantVector(0.5), zeroVector(), constantVector(0.5)}; }

/// The lanes of three forms that are the coordinates of a noise, from one of them on; none of y where that
/// is 0.
struct NoiseOperands {
    const double *x, *y, *z;

    template <bool shifted, bool ground>
    HWY_INLINE NoisePiece<shifted, ground> piece(std::size_t i) const {
        return {number(x + i), coordinateY<ground>(i), number(z + i)};
    }
    /// A piece whose reaches are known.
    template <bool shifted, bool ground>
    HWY_INLINE NoisePiece<shifted, ground> piece(const NoiseReaches& reaches, std::size_t i) const {
        // Errors of coordinates grow where they are taken.
        if constexpr (shifted)
            return piece<shifted, ground>(i);
        else
            return {number(x + i), coordinateY<ground>(i), number(z + i), reaches, i};
    }
    std::array<const double*, 3> centers() const { return {x, y, z}; }
    NoiseWays ways(const NoiseReaches& reaches) const {
        return {{x + batchLanes, y != nullptr ? y + batchLanes : nullptr, z + batchLanes},
                {reaches.axis[0], reaches.axis[1], reaches.axis[2]}};
    }

  private:
    template <bool ground>
    HWY_INLINE AffineNumber coordinateY(std::size_t i) const {
        if constexpr (ground)
            return {zeroVector(), zeroVector(), zeroVector()};
        else
            return number(y + i);
    }
    static HWY_INLINE AffineNumber number(const double* lanes) {
        const Doubles d;
        return {hn::LoadU(d, lanes), hn::LoadU(d, lanes + batchLanes), hn::LoadU(d, lanes + 2 * batchLanes)};
    }
};

HWY_INLINE void storeNumber(const AffineNumber& p, double* lanes) {
    const Doubles d;
    hn::Store(p.a, d, lanes);
    hn::Store(p.b, d, lanes + batchLanes);
    hn::Store(p.e, d, lanes + 2 * batchLanes);
}

/// What is to be found out where the noise is known to stay within `limit` of its centre.
template <bool shifted, bool ground>
HWY_INLINE NoiseNeeds noiseNeeds(const NoiseOperands& operands, std::size_t lanes, double limit,
                                 NoiseReaches& reaches) {
    NoiseNeeds needs;
    for (std::size_t i = 0; i < lanes; i += vectorLanes) {
        const auto piece = operands.piece<shifted, ground>(i);
        piece.keep(reaches, i);
        const Mask near = piece.within(limit);
        const auto bit = [i](Mask some) HWY_ATTR {
            return std::uint64_t{!hn::AllFalse(Doubles(), some)} << (i / vectorLanes);
        };
        if constexpr (shifted) {
            needs.gradients |= bit(near);
        } else {
            const Mask thin = piece.isThin();
            needs.lines |= bit(hn::And(near, thin));
            needs.gradients |= bit(hn::AndNot(thin, near));
        }
    }
    return needs;
}

/// Noise of the pieces before scaling, and its derivatives; only of the vectors that were asked for.
template <bool shifted, bool ground>
class NoiseFound {
  public:
    static constexpr NoiseOrder order = ground ? NoiseOrder::slopesXZ : NoiseOrder::gradient;

    /// `component` of lattice noise.
    HWY_INLINE NoiseFound(int component, const NoiseOperands& operands, std::size_t lanes, double limit)
        : operands_(operands), needs_(noiseNeeds<shifted, ground>(operands, lanes, limit, reaches_)) {
        if constexpr (shifted) {
            if (needs_.gradients != 0)
                gradientNoise<order>(operands.centers(), lanes, needs_.gradients, gradients_);
        } else {
            if (needs_.lines != 0)
                latticeNoiseAlong(component, operands.centers(), operands.ways(reaches_), lanes, needs_.lines,
                                  lines_);
            if (HWY_UNLIKELY(needs_.gradients != 0))
                latticeNoise<order>(component, operands.centers(), lanes, needs_.gradients, gradients_);
        }
    }

    /// Whether any lane of the vector at i was.
    HWY_INLINE bool isNear(std::size_t i) const {
        return (((needs_.lines | needs_.gradients) >> (i / vectorLanes)) & 1u) != 0;
    }
    HWY_INLINE NoisePiece<shifted, ground> piece(std::size_t i) const {
        return operands_.piece<shifted, ground>(reaches_, i);
    }
    HWY_INLINE AffineNumber developed(const NoisePiece<shifted, ground>& piece, std::size_t i) const {
        if constexpr (shifted) {
            return piece.developed(gradients_.load<order>(i));
        } else {
            const Doubles d;
            const bool any = ((needs_.gradients >> (i / vectorLanes)) & 1u) != 0;
            if (HWY_UNLIKELY(((needs_.lines >> (i / vectorLanes)) & 1u) == 0))
                return piece.developed(gradients_.load<order>(i));
            const AffineNumber thin =
                piece.developed(hn::Load(d, lines_.value + i), hn::Load(d, lines_.slope + i),
                                hn::Load(d, lines_.bend + i), hn::Load(d, lines_.outside + i));
            if (HWY_LIKELY(!any)) return thin;
            return chooseNumber(piece.isThin(), thin, piece.developed(gradients_.load<order>(i)));
        }
    }

  private:
    const NoiseOperands& operands_;
    NoiseReaches reaches_;
    NoiseNeeds needs_;
    NoiseLines lines_;
    NoiseColumns gradients_;
};

/// noise() of a generator 0 to 3, for `lanes` lanes. It has a value for every argument. With `ground`, the
/// operands have no y.
template <int generator, bool ground>
HWY_NOINLINE void affineNoiseOf(const NoiseOperands& operands, std::size_t lanes, double* target) {
    constexpr bool shifted = generator == 3;
    constexpr double scale = noiseScale(generator);
    // Where the slope alone leads out of most of [0, 1] nothing would come of looking closer.
    constexpr double limit = 0.7 / scale;
    const NoiseFound<shifted, ground> found(0, operands, lanes, limit);
    for (std::size_t i = 0; i < lanes; i += vectorLanes) {
        if (!found.isNear(i)) {
            storeNumber(anywhereInUnit(), target + i);
            continue;
        }
        const auto piece = found.piece(i);
        const AffineNumber raw = found.developed(piece, i);
        const AffineNumber scaled{
            scaledNoise(generator, raw.a), hn::Mul(raw.b, constantVector(scale)),
            hn::MulAdd(raw.e, constantVector(scale * (1 + noiseRoundings)), constantVector(noiseRoundings))};
        storeNumber(chooseNumber(piece.within(limit), clippedToUnit(scaled), anywhereInUnit()), target + i);
    }
}
HWY_INLINE void affineNoise(int generator, const NoiseOperands& operands, std::size_t lanes, double* target) {
    withNoiseKind(generator, operands.y == nullptr, [&](auto kind, auto ground) HWY_ATTR {
        affineNoiseOf<kind(), ground()>(operands, lanes, target);
    });
}

/// One component of the vector noise.
inline HWY_NOINLINE void affineVectorNoise(int component, const NoiseOperands& operands, std::size_t lanes,
                                           double* target) {
    const AffineNumber anywhere{zeroVector(), zeroVector(), constantVector(vectorNoiseLimit)};
    const NoiseFound<false, false> found(component, operands, lanes, vectorNoiseLimit);
    for (std::size_t i = 0; i < lanes; i += vectorLanes) {
        if (!found.isNear(i)) {
            storeNumber(anywhere, target + i);
            continue;
        }
        const auto piece = found.piece(i);
        storeNumber(chooseNumber(piece.within(vectorNoiseLimit), found.developed(piece, i), anywhere),
                    target + i);
    }
}

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
