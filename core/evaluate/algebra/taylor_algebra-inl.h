// SPDX-License-Identifier: GPL-3.0-or-later
// Included once per instruction set. Values with gradients, and how far a function is from its tangent along
// a ray.
#if defined(ISOSCOPE_EVALUATE_TANGENT_ALGEBRA_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOSCOPE_EVALUATE_TANGENT_ALGEBRA_INL
#undef ISOSCOPE_EVALUATE_TANGENT_ALGEBRA_INL
#else
#define ISOSCOPE_EVALUATE_TANGENT_ALGEBRA_INL
#endif

#include <hwy/highway.h>

#include <array>

#include "core/evaluate/algebra/affine_elementary-inl.h"
#include "core/evaluate/algebra/affine_noise-inl.h"
#include "core/evaluate/algebra/gradient_algebra-inl.h"
#include "core/evaluate/algebra/slope_operations.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

/// A value with its gradient as GradientAlgebra computes them at a place on a ray, and where the function can
/// be around it: for s in [-1, 1], the way from there in parts of a reach, it lies within remainder * s^2 +
/// rounding of value + slope * s. Nothing is known where the value, remainder or rounding is not finite.
struct TangentNumber {
    GradientNumber point;
    Vector slope, remainder, rounding;

    TangentNumber() = default;
    // One vector after the other: what is copied as a whole the compiler keeps in memory as well.
    TangentNumber(const TangentNumber& p)
        : point(p.point.value, p.point.x, p.point.y, p.point.z),
          slope(p.slope),
          remainder(p.remainder),
          rounding(p.rounding) {}
    TangentNumber& operator=(const TangentNumber& p) {
        point.value = p.point.value;
        point.x = p.point.x;
        point.y = p.point.y;
        point.z = p.point.z;
        slope = p.slope;
        remainder = p.remainder;
        rounding = p.rounding;
        return *this;
    }
    HWY_INLINE TangentNumber(const GradientNumber& p, Vector r, Vector b, Vector n)
        : point(p), slope(r), remainder(b), rounding(n) {}
    HWY_INLINE TangentNumber(FlatNumber c)
        : point(c), slope(zeroVector()), remainder(zeroVector()), rounding(zeroVector()) {}
};

/// The operations are those of TaylorEvaluator::covers(); of others nothing is known.
class TaylorAlgebra {
  public:
    using Number = TangentNumber;
    using Uniform = FlatNumber;
    using Gradients = GradientAlgebra;
    static constexpr std::size_t components = 7;
    static constexpr bool fuses = true;

    HWY_INLINE void begin(const TapeWorkspace&, std::size_t) {}

    static HWY_INLINE Number load(const double* lanes) {
        const auto at = [=](std::size_t c) HWY_ATTR { return hn::LoadU(Doubles(), lanes + c * batchLanes); };
        return {Gradients::load(lanes), at(4), at(5), at(6)};
    }
    static HWY_INLINE void store(const Number& p, double* lanes) {
        Gradients::store(p.point, lanes);
        const Vector rest[] = {p.slope, p.remainder, p.rounding};
        for (std::size_t c = 0; c < 3; ++c) hn::Store(rest[c], Doubles(), lanes + (4 + c) * batchLanes);
    }
    static HWY_INLINE Uniform uniform(double value) { return {constantVector(value)}; }
    static HWY_INLINE Number widen(Uniform c) { return c; }
    static HWY_INLINE bool isExactLane(const double*) { return false; }
    static HWY_INLINE Number choose(Mask first, const Number& p, const Number& q) {
        return {Gradients::choose(first, p.point, q.point), hn::IfThenElse(first, p.slope, q.slope),
                hn::IfThenElse(first, p.remainder, q.remainder),
                hn::IfThenElse(first, p.rounding, q.rounding)};
    }
    static HWY_INLINE Number increment(const Number& p) { return add(p, uniform(1)); }

    static HWY_INLINE Number negate(const Number& p) {
        return {Gradients::negate(p.point), hn::Neg(p.slope), p.remainder, p.rounding};
    }
    static HWY_INLINE Number add(const Number& p, const Number& q) {
        return sum(Gradients::add(p.point, q.point), p, q);
    }
    static HWY_INLINE Number add(const Number& p, Uniform c) {
        return moved(p, Gradients::add(p.point, c), p.slope);
    }
    static HWY_INLINE Number add(Uniform c, const Number& p) { return add(p, c); }
    static HWY_INLINE Number subtract(const Number& p, const Number& q) {
        return sum(Gradients::subtract(p.point, q.point), p, negate(q));
    }
    static HWY_INLINE Number subtract(const Number& p, Uniform c) {
        return moved(p, Gradients::subtract(p.point, c), p.slope);
    }
    static HWY_INLINE Number subtract(Uniform c, const Number& p) {
        return moved(p, Gradients::subtract(c, p.point), hn::Neg(p.slope));
    }

    static HWY_INLINE Number multiply(const Number& p, const Number& q) {
        const Vector mostP = linearSize(p), mostQ = linearSize(q);
        const Vector sizeP = hn::Add(mostP, hn::Add(p.remainder, p.rounding));
        const Vector slope = hn::MulAdd(p.point.value, q.slope, hn::Mul(q.point.value, p.slope));
        const Vector remainder = hn::MulAdd(
            sizeP, q.remainder, hn::MulAdd(mostQ, p.remainder, hn::Abs(hn::Mul(p.slope, q.slope))));
        const Vector rounding = hn::MulAdd(sizeP, q.rounding, hn::Mul(mostQ, p.rounding));
        return {Gradients::multiply(p.point, q.point), slope, rounded(remainder),
                rounded(rounding, hn::Mul(mostP, mostQ))};
    }
    static HWY_INLINE Number multiply(const Number& p, Uniform c) {
        const Vector size = hn::Abs(c.value);
        const Number result{Gradients::multiply(p.point, c), hn::Mul(p.slope, c.value),
                            rounded(hn::Mul(p.remainder, size)), hn::Mul(p.rounding, size)};
        return withRounding(result);
    }
    static HWY_INLINE Number multiply(Uniform c, const Number& p) { return multiply(p, c); }
    static HWY_INLINE Number square(const Number& p) {
        const Vector most = linearSize(p);
        const Vector twice = hn::Add(hn::Add(most, most), hn::Add(p.remainder, p.rounding));
        const Vector slope = hn::Mul(p.point.value, p.slope);
        return {Gradients::square(p.point), hn::Add(slope, slope),
                rounded(hn::MulAdd(p.slope, p.slope, hn::Mul(twice, p.remainder))),
                rounded(hn::Mul(twice, p.rounding), hn::Mul(most, most))};
    }
    static HWY_INLINE Number divide(const Number& p, const Number& q) {
        // f(q) = 1 / q: f'' = 2 / q^3.
        const Vector inverse = hn::Div(constantVector(1), q.point.value);
        const Vector nearest = hn::Sub(hn::Abs(q.point.value), reachOf(q));
        const Vector steep = hn::Div(constantVector(1), hn::Mul(hn::Mul(nearest, nearest), nearest));
        const Number reciprocal = onlyWhere(
            isClear(nearest, q), developed(q, {inverse, zeroVector(), zeroVector(), zeroVector()},
                                           hn::Neg(hn::Mul(inverse, inverse)), steep, hn::Abs(inverse)));
        const Number quotient = multiply(p, reciprocal);
        const GradientNumber exact = Gradients::divide(p.point, q.point);
        // Their values differ by two roundings.
        return withRounding({exact, quotient.slope, quotient.remainder, quotient.rounding});
    }
    static HWY_INLINE Number divide(const Number& p, Uniform c) {
        const Vector size = hn::Abs(c.value);
        return withRounding({Gradients::divide(p.point, c), hn::Div(p.slope, c.value),
                             rounded(hn::Div(p.remainder, size)), hn::Div(p.rounding, size)});
    }
    static HWY_INLINE Number divide(Uniform c, const Number& p) { return divide(widen(c), p); }

    static HWY_INLINE Number squareRoot(const Number& p) {
        // f'' = -1/4 p^(-3/2), largest at the least p.
        const GradientNumber root = Gradients::squareRoot(p.point);
        const Vector least = hn::Sub(p.point.value, reachOf(p));
        const Vector steep = hn::Div(constantVector(0.125), hn::Mul(least, hn::Sqrt(least)));
        return onlyWhere(isClear(least, p),
                         developed(p, root, hn::Div(constantVector(0.5), root.value), steep, root.value));
    }
    static HWY_INLINE Number exponential(const Number& p) {
        const GradientNumber value = Gradients::exponential(p.point);
        const Vector reach = reachOf(p);
        // exp(1) / 2 where the reach is at most 1.
        return onlyWhere(hn::Lt(reach, constantVector(1)),
                         developed(p, value, value.value, hn::Mul(value.value, constantVector(1.36)),
                                   hn::Mul(value.value, constantVector(8))));
    }
    static HWY_INLINE Number sine(const Number& p) {
        Number sines, cosines;
        sineAndCosine(p, sines, cosines);
        return sines;
    }
    static HWY_INLINE Number cosine(const Number& p) {
        Number sines, cosines;
        sineAndCosine(p, sines, cosines);
        return cosines;
    }
    static HWY_INLINE void sineAndCosine(const Number& p, Number& sines, Number& cosines) {
        GradientNumber s, c;
        Gradients::sineAndCosine(p.point, s, c);
        const Mask safe = hn::Lt(hn::Abs(p.point.value), constantVector(largestAngle));
        const Vector steep = constantVector(0.5), greatest = constantVector(angleError / roundingUnit);
        sines = onlyWhere(safe, developed(p, s, c.value, steep, greatest));
        cosines = onlyWhere(safe, developed(p, c, hn::Neg(s.value), steep, greatest));
    }

    static HWY_INLINE Number cycle(const Number& p) {
        const Vector angle = PointAlgebra::cycleAngle(p.point.value);
        const Vector slope = hn::Mul(constantVector(turn), PointAlgebra::cosine(angle));
        const Mask safe = hn::Lt(hn::Abs(p.point.value), constantVector(largestAngle));
        // Neither a turn that is rounded nor the jumps it makes count for more.
        const Vector greatest = constantVector((4 * angleError + 16 * turnError) / roundingUnit);
        return onlyWhere(safe, developed(p, Gradients::cycle(p.point), slope,
                                         constantVector(0.5 * turn * turn), greatest));
    }
    static HWY_INLINE Number absolute(const Number& p) {
        const Vector reach = reachOf(p);
        const Mask decided = hn::Gt(hn::Abs(p.point.value), reach);
        const Mask negative = hn::Lt(p.point.value, zeroVector());
        const Vector slope = hn::IfThenElse(negative, hn::Neg(p.slope), p.slope);
        return leveled(decided, {Gradients::absolute(p.point), slope, p.remainder, p.rounding}, reach);
    }
    template <class P, class Q>
    static HWY_INLINE Number minimum(const P& p, const Q& q) {
        return either(p, q, Gradients::minimum(point(p), point(q)), false);
    }
    template <class P, class Q>
    static HWY_INLINE Number maximum(const P& p, const Q& q) {
        return either(p, q, Gradients::maximum(point(p), point(q)), true);
    }

    // clang-format off
#define ISOSCOPE_UNARY(operation) \
    static HWY_INLINE Number operation(const Number& p) { return unknown(Gradients::operation(p.point)); }
#define ISOSCOPE_BINARY(operation) \
    template <class P, class Q> static HWY_INLINE Number operation(const P& p, const Q& q) { return unknown(Gradients::operation(point(p), point(q))); }
    ISOSCOPE_OTHER_OPERATIONS(ISOSCOPE_UNARY, ISOSCOPE_BINARY)
#undef ISOSCOPE_BINARY
#undef ISOSCOPE_UNARY
    // clang-format on
    static HWY_INLINE Number select3(const Number& p, const Number& q, const Number& r) {
        return unknown(Gradients::select3(p.point, q.point, r.point));
    }
    static HWY_INLINE Number select4(const Number& p, const Number& q, const Number& r, const Number& s) {
        return unknown(Gradients::select4(p.point, q.point, r.point, s.point));
    }
    /// noise() of a generator 0 to 3; of 0 to 2 also without lanes for a y of 0.
    static void noise(int generator, const std::array<const double*, 3>& place, std::size_t lanes,
                      double* target) {
        withNoiseKind(generator, place[1] == nullptr, [&](auto kind, auto ground) HWY_ATTR {
            noiseOf<kind(), ground()>(0, place, lanes, target);
        });
    }
    static void scalarOperation(const Instruction& instruction, const CrackleSettings* crackle,
                                const std::array<const double*, 4>& operands, double* target,
                                std::size_t lanes) {
        const double *a = operands[0], *b = operands[1], *c = operands[2];
        if (instruction.operation == Operation::noise) {
            evaluateNoise<TaylorAlgebra>(operands[0], {operands[1], operands[2], operands[3]}, lanes, target);
        } else if (isVectorNoise(instruction.operation)) {
            noiseOf<noGenerator>(noiseComponent(instruction.operation), {a, b, c}, lanes, target);
        } else {
            Gradients::scalarOperation(instruction, crackle, operands, target, lanes);
            for (std::size_t i = 0; i < lanes; i += vectorLanes)
                store(unknown(Gradients::load(target + i)), target + i);
        }
    }

  private:
    /// In place of a generator.
    static constexpr int noGenerator = -1;

    static HWY_INLINE const GradientNumber& point(const Number& p) { return p.point; }
    static HWY_INLINE Uniform point(Uniform c) { return c; }

    static HWY_INLINE Number unknown(const GradientNumber& p) {
        return {p, zeroVector(), constantVector(unlimited), constantVector(unlimited)};
    }
    static HWY_INLINE Number onlyWhere(Mask known, const Number& p) {
        return {p.point, p.slope, p.remainder, hn::IfThenElse(known, p.rounding, constantVector(unlimited))};
    }

    /// No point of the tangent is further from 0.
    static HWY_INLINE Vector linearSize(const Number& p) {
        return hn::Mul(hn::Add(hn::Abs(p.point.value), hn::Abs(p.slope)), constantVector(inflation));
    }
    /// No value is further from that of the point.
    static HWY_INLINE Vector reachOf(const Number& p) {
        return hn::Mul(hn::Add(hn::Abs(p.slope), hn::Add(p.remainder, p.rounding)),
                       constantVector(inflation));
    }
    static HWY_INLINE Vector reachOf(Uniform) { return zeroVector(); }
    /// Whether `least`, the distance of p from 0, is not lost in roundings, and its powers are neither.
    static HWY_INLINE Mask isClear(Vector least, const Number& p) {
        const Vector size = hn::Abs(p.point.value);
        const Vector clear = hn::MulAdd(size, constantVector(1e-3), constantVector(1e-90));
        return hn::And(hn::Gt(least, clear), hn::Lt(size, constantVector(1e90)));
    }
    /// `error`, itself rounded, and what a few roundings of numbers up to `greatest` add to it.
    static HWY_INLINE Vector rounded(Vector error, Vector greatest) {
        const Vector rounding =
            hn::MulAdd(greatest, constantVector(6 * roundingUnit), constantVector(underflow));
        return hn::MulAdd(error, constantVector(inflation), rounding);
    }
    static HWY_INLINE Vector rounded(Vector error) {
        return hn::MulAdd(error, constantVector(inflation), constantVector(underflow));
    }
    /// Value and slope are rounded a few times.
    static HWY_INLINE Number withRounding(const Number& p) {
        return {p.point, p.slope, p.remainder,
                rounded(p.rounding, hn::Add(hn::Abs(p.point.value), hn::Abs(p.slope)))};
    }
    /// `p` and a constant, with the value and slope of `point` and `slope`: nothing but the value is rounded.
    /// Where p's slope is not finite, its rounding is not either.
    static HWY_INLINE Number moved(const Number& p, const GradientNumber& point, Vector slope) {
        return {point, slope, p.remainder, rounded(p.rounding, hn::Abs(point.value))};
    }

    static HWY_INLINE Number sum(const GradientNumber& point, const Number& p, const Number& q) {
        return withRounding({point, hn::Add(p.slope, q.slope), rounded(hn::Add(p.remainder, q.remainder)),
                             hn::Add(p.rounding, q.rounding)});
    }

    /// A function of p whose value at the point is that of `value`, up to a few roundings of numbers up to
    /// `greatest`, with the slope `slope` there; `halfCurvature` is half of its second derivative's bound.
    static HWY_INLINE Number developed(const Number& p, const GradientNumber& value, Vector slope,
                                       Vector halfCurvature, Vector greatest) {
        const Vector size = hn::Abs(slope), way = hn::Add(hn::Abs(p.slope), p.remainder);
        const Vector remainder = hn::MulAdd(size, p.remainder, hn::Mul(halfCurvature, hn::Mul(way, way)));
        const Vector beside = hn::Mul(hn::Add(hn::Add(way, way), p.rounding), p.rounding);
        const Vector carried = hn::MulAdd(size, p.rounding, hn::Mul(halfCurvature, beside));
        // Slope and curvature are rounded themselves.
        const Vector own = hn::Add(greatest, hn::Mul(size, hn::Abs(p.slope)));
        return {value, hn::Mul(slope, p.slope), rounded(hn::Mul(remainder, constantVector(1 + 1e-12))),
                rounded(hn::Mul(carried, constantVector(1 + 1e-12)), hn::Mul(own, constantVector(2)))};
    }

    /// `p` where that is certain, elsewhere nothing but that no value is further than `reach` from that of
    /// the point.
    static HWY_INLINE Number leveled(Mask certain, const Number& p, Vector reach) {
        return {p.point, hn::IfThenElseZero(certain, p.slope), hn::IfThenElseZero(certain, p.remainder),
                hn::IfThenElse(certain, p.rounding, reach)};
    }
    static HWY_INLINE Number either(Uniform c, const Number& p, const GradientNumber& point, bool greater) {
        return either(p, c, point, greater);
    }
    template <class Q>
    static HWY_INLINE Number either(const Number& p, const Q& q, const GradientNumber& point, bool greater) {
        const Number difference = subtract(p, q);
        const Vector value = difference.point.value, reach = reachOf(difference);
        const Mask first = hn::Gt(greater ? value : hn::Neg(value), reach);
        const Mask second = hn::Gt(greater ? hn::Neg(value) : value, reach);
        const Number sure = choose(first, p, q);
        // hn::Max may drop what is not a number, a sum does not.
        const Vector all = hn::Add(reachOf(p), reachOf(q));
        const Mask known = hn::Lt(all, constantVector(unlimited));
        const Vector apart =
            hn::IfThenElse(known, hn::Max(reachOf(p), reachOf(q)), constantVector(unlimited));
        return leveled(hn::Or(first, second), {point, sure.slope, sure.remainder, sure.rounding}, apart);
    }

    /// Noise of a generator 0 to 3 or a component of the vector noise. With `ground`, y is 0 and has no
    /// lanes.
    template <int generator, bool ground = false>
    static HWY_NOINLINE void noiseOf(int component, const std::array<const double*, 3>& coordinates,
                                     std::size_t lanes, double* target) {
        constexpr NoiseOrder order = ground ? NoiseOrder::slopesXZ : NoiseOrder::gradient;
        NoiseColumns noise;
        if constexpr (generator == 3)
            gradientNoise<order>(coordinates, lanes, allVectors, noise);
        else
            latticeNoise<order>(component, coordinates, lanes, allVectors, noise);
        for (std::size_t i = 0; i < lanes; i += vectorLanes) {
            const Number x = load(coordinates[0] + i), z = load(coordinates[2] + i);
            const Number y = ground ? x : load(coordinates[1] + i);
            const Number at[] = {x, y, z};
            const NoiseSample raw = noise.load<order>(i);
            const Number found = noiseAlong<generator == 3, ground>(raw, at);
            store(generator == noGenerator ? found : finished<generator, ground>(raw, at, found), target + i);
        }
    }
    template <bool ground>
    static HWY_INLINE GradientNumber chain(const NoiseSample& noise, const Number (&at)[3]) {
        if constexpr (ground)
            return Gradients::chain(noise, at[0].point, at[2].point);
        else
            return Gradients::chain(noise, at[0].point, at[1].point, at[2].point);
    }

    /// With `ground`, y is not read.
    template <bool shifted, bool ground>
    static HWY_INLINE Number noiseAlong(const NoiseSample& raw, const Number (&at)[3]) {
        constexpr NoiseBounds bounds = shifted ? gradientNoiseBounds : latticeNoiseBounds;
        const Vector slopes[] = {raw.x, raw.y, raw.z};
        Vector slope = zeroVector(), remainder = slope, rounding = slope, extent = slope;
        Vector ways = slope, squares = slope, errors = slope;
        for (std::size_t k = 0; k < 3; ++k) {
            if (ground && k == 1) continue;
            const Number& p = at[k];
            const Vector size = hn::Abs(p.point.value), steepness = hn::Abs(slopes[k]);
            const Vector way = hn::Mul(hn::Add(hn::Abs(p.slope), p.remainder), constantVector(inflation));
            Vector error = p.rounding;
            const Vector farthest = hn::Add(size, hn::Add(way, error));
            // See NoisePiece.
            if constexpr (shifted)
                error =
                    hn::MulAdd(hn::Add(farthest, constantVector(10000001)), constantVector(4.6e-16), error);
            extent = hn::Add(extent, farthest);
            slope = hn::MulAdd(slopes[k], p.slope, slope);
            remainder = hn::MulAdd(steepness, p.remainder, remainder);
            rounding = hn::MulAdd(steepness, error, rounding);
            ways = hn::Add(ways, way);
            squares = hn::MulAdd(way, way, squares);
            errors = hn::Add(errors, error);
        }
        const Vector halfCurvature = halfCurvatureOf<shifted, ground>(bounds, at[1]);
        const Vector mixed = hn::MulSub(ways, ways, squares);
        const Vector separate = hn::MulAdd(squares, constantVector(0.5 * bounds.bend),
                                           hn::Mul(mixed, constantVector(0.5 * bounds.twist)));
        // (way s + error)^2, all coordinates together.
        remainder = hn::Add(remainder, hn::Min(separate, hn::Mul(squares, halfCurvature)));
        const Vector beside = hn::Mul(hn::Add(hn::Add(ways, ways), errors), errors);
        rounding = hn::MulAdd(beside, constantVector(0.5 * bounds.curvature), rounding);
        const Mask usable = hn::Lt(extent, constantVector(2147483647.0));
        return onlyWhere(
            usable,
            {chain<ground>(raw, at), slope,
             hn::MulAdd(remainder, constantVector(inflation), constantVector(underflow)),
             hn::Add(rounding, hn::Mul(hn::Add(constantVector(1), ways), constantVector(noiseRoundings)))});
    }
    template <bool shifted, bool ground>
    static HWY_INLINE Vector halfCurvatureOf(const NoiseBounds& bounds, const Number& y) {
        if constexpr (ground) return constantVector(0.5 * latticePlaneCurvature);
        const Vector everywhere = constantVector(0.5 * bounds.curvature);
        if constexpr (shifted) return everywhere;
        // As in noise(x, 0, z).
        const Vector away = hn::Add(hn::Abs(y.slope), hn::Add(y.remainder, y.rounding));
        const Mask flat =
            hn::And(hn::Eq(away, zeroVector()), hn::Eq(hn::Round(y.point.value), y.point.value));
        return hn::IfThenElse(flat, constantVector(0.5 * latticePlaneCurvature), everywhere);
    }

    /// Offset and scaled, then clipped to [0, 1].
    template <int generator, bool ground>
    static HWY_INLINE Number finished(const NoiseSample& raw, const Number (&at)[3], const Number& p) {
        constexpr NoiseOrder order = ground ? NoiseOrder::slopesXZ : NoiseOrder::gradient;
        const NoiseSample sample = finishedNoise<order>(generator, raw);
        const Vector scale = constantVector(noiseScale(generator));
        const Vector unclipped = scaledNoise(generator, raw.value);
        const Number scaled{chain<ground>(sample, at), hn::Mul(p.slope, scale),
                            rounded(hn::Mul(p.remainder, scale)),
                            rounded(hn::Mul(p.rounding, scale), constantVector(4))};
        const Vector reach = reachOf(scaled);
        const Mask inside = hn::And(hn::Gt(hn::Sub(unclipped, reach), zeroVector()),
                                    hn::Lt(hn::Add(unclipped, reach), constantVector(1)));
        return leveled(inside, scaled, reach);
    }
};

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
