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

#include "core/evaluate/affine_number-inl.h"
#include "core/evaluate/noise-inl.h"
#include "core/numeric/noise_bounds.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

/// More than the roundings of a noise amount to, relative to sizes about 1.
constexpr double noiseRoundings = 1e-14;

/// A piece of a line in the space of a noise. Coordinates of gradient noise are rounded at a distance of 10^7
/// from where they are; that is part of their error (`shifted`).
class NoisePiece {
  public:
    HWY_INLINE NoisePiece(const AffineNumber& x, const AffineNumber& y, const AffineNumber& z, bool shifted)
        : p_{x, y, z} {
        sum_ = squares_ = zeroVector();
        Vector extent = zeroVector();
        for (int k = 0; k < 3; ++k) {
            AffineNumber& p = p_[k];
            const Vector size = hn::Abs(p.a);
            // What is not known, or undefined, reaches infinitely far, or is not a number.
            const Vector radius = hn::Mul(hn::Add(hn::Abs(p.b), hn::Abs(p.e)), constantVector(inflation));
            Vector reach = hn::MulAdd(size, constantVector(1e-16), radius);
            extent = hn::Add(extent, hn::Add(size, reach));
            if (shifted) {
                const Vector farthest = hn::Add(hn::Add(size, reach), constantVector(10000001));
                // At the centre and at the point that is asked for: half a unit in the last place each.
                const Vector rounding = hn::Mul(farthest, constantVector(2.3e-16));
                p.e = hn::Add(p.e, rounding);
                reach = hn::Add(reach, rounding);
            }
            sum_ = hn::Add(sum_, reach);
            squares_ = hn::MulAdd(reach, reach, squares_);
        }
        // Noise takes coordinates beyond its lattice as 0.
        usable_ = hn::Lt(extent, constantVector(2147483647.0));
    }

    /// Lanes with known coordinates on the lattice where the noise cannot get further than `limit` from its
    /// value at the centre, by the bounds on its slope.
    HWY_INLINE Mask within(double limit, const NoiseBounds& bounds) const {
        const double steepest = bounds.lipschitz * (1 + noiseRoundings) / limit;
        const Mask near =
            hn::Or(hn::Lt(sum_, constantVector(limit / bounds.slope)),
                   hn::Lt(hn::Mul(squares_, constantVector(steepest * steepest)), constantVector(1)));
        return hn::And(usable_, near);
    }

    /// The noise along the piece from its value and derivatives at the centre.
    HWY_INLINE AffineNumber developed(const NoiseSample& noise, const NoiseBounds& bounds) const {
        const Vector slope =
            hn::MulAdd(noise.x, p_[0].b, hn::MulAdd(noise.y, p_[1].b, hn::Mul(noise.z, p_[2].b)));
        const Vector error = hn::MulAdd(
            hn::Abs(noise.x), p_[0].e,
            hn::MulAdd(hn::Abs(noise.y), p_[1].e, hn::MulAdd(hn::Abs(noise.z), p_[2].e, bend(bounds))));
        const Vector length = hn::Mul(hn::Sqrt(squares_), constantVector(1 + noiseRoundings));
        const Vector flat = hn::Min(hn::Mul(sum_, constantVector(bounds.slope)),
                                    hn::Mul(length, constantVector(bounds.lipschitz)));
        const Vector rounding =
            hn::Mul(hn::Add(hn::Add(flat, error), constantVector(1)), constantVector(noiseRoundings));
        // A slope is worth its name when it leaves open half of what the bound on the slope does.
        const Mask useful = hn::Le(error, half(flat));
        // No branch here or below: what comes so late is not foreseen, and to wait for it costs more.
        return {noise.value, hn::IfThenElseZero(useful, slope),
                hn::Add(hn::IfThenElse(useful, error, flat), rounding)};
    }

  private:
    /// How far the noise can get from its tangent at the centre, coordinates without error.
    HWY_INLINE Vector bend(const NoiseBounds& bounds) const {
        const Vector mixed = hn::MulSub(sum_, sum_, squares_);
        const Vector separate = hn::MulAdd(squares_, constantVector(0.5 * bounds.bend),
                                           hn::Mul(mixed, constantVector(0.5 * bounds.twist)));
        return hn::Min(separate, hn::Mul(squares_, constantVector(0.5 * bounds.curvature)));
    }

    AffineNumber p_[3];
    Mask usable_;
    Vector sum_, squares_;  ///< of the reaches, rounded up where it matters
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

/// noise() of a generator 0 to 3. It has a value for every argument.
inline HWY_NOINLINE AffineNumber affineNoiseOf(int generator, const AffineNumber& x, const AffineNumber& y,
                                               const AffineNumber& z) {
    const NoiseBounds& bounds = generator == 3 ? gradientNoiseBounds : latticeNoiseBounds;
    const double scale = noiseScale(generator);
    const NoisePiece piece(x, y, z, generator == 3);
    // Where the slope alone leads out of most of [0, 1] nothing would come of looking closer.
    const Mask near = piece.within(0.7 / scale, bounds);
    if (hn::AllFalse(Doubles(), near)) return anywhereInUnit();
    const NoiseSample sample = rawNoiseAt<NoiseOrder::gradient>(generator, x.a, y.a, z.a);
    const AffineNumber raw = piece.developed(sample, bounds);
    const AffineNumber scaled{
        scaledNoise(generator, raw.a), hn::Mul(raw.b, constantVector(scale)),
        hn::MulAdd(raw.e, constantVector(scale * (1 + noiseRoundings)), constantVector(noiseRoundings))};
    return chooseNumber(near, clippedToUnit(scaled), anywhereInUnit());
}

/// One component of the vector noise.
inline HWY_NOINLINE AffineNumber affineVectorNoiseOf(int component, const AffineNumber& x,
                                                     const AffineNumber& y, const AffineNumber& z) {
    const AffineNumber anywhere{zeroVector(), zeroVector(), constantVector(vectorNoiseLimit)};
    const NoisePiece piece(x, y, z, false);
    const Mask near = piece.within(vectorNoiseLimit, latticeNoiseBounds);
    if (hn::AllFalse(Doubles(), near)) return anywhere;
    const NoiseSample sample = latticeNoiseAt<NoiseOrder::gradient>(component, x.a, y.a, z.a);
    return chooseNumber(near, piece.developed(sample, latticeNoiseBounds), anywhere);
}

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
