// SPDX-License-Identifier: GPL-3.0-or-later
// Included once per instruction set. Forward-mode differentiation: a value and its derivatives along x, y, z.
// The values are those of PointAlgebra, bit for bit; what the derivatives are at singular places is stated at
// GradientEvaluator.
#if defined(ISOSCOPE_EVALUATE_GRADIENT_ALGEBRA_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOSCOPE_EVALUATE_GRADIENT_ALGEBRA_INL
#undef ISOSCOPE_EVALUATE_GRADIENT_ALGEBRA_INL
#else
#define ISOSCOPE_EVALUATE_GRADIENT_ALGEBRA_INL
#endif

#include <hwy/highway.h>

#include <array>
#include <cmath>

#include "core/evaluate/algebra/noise-inl.h"
#include "core/evaluate/algebra/point_algebra-inl.h"
#include "core/evaluate/gradient_evaluator.h"
#include "core/evaluate/tape/tape_workspace.h"
#include "core/function/scalar_operations.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

/// A number that is the same for all lanes: its derivatives are 0.
struct FlatNumber {
    Vector value;
};

struct GradientNumber {
    Vector value, x, y, z;

    GradientNumber() = default;
    HWY_INLINE GradientNumber(Vector v, Vector dx, Vector dy, Vector dz) : value(v), x(dx), y(dy), z(dz) {}
    HWY_INLINE GradientNumber(FlatNumber flat)
        : value(flat.value), x(hn::Zero(Doubles())), y(hn::Zero(Doubles())), z(hn::Zero(Doubles())) {}
};

struct GradientAlgebra {
    using Number = GradientNumber;
    using Uniform = FlatNumber;
    using Point = PointAlgebra;
    static constexpr std::size_t components = 4;
    /// Whether pairs of sums and products are run as one.
    static constexpr bool fuses = false;

    static HWY_INLINE Number load(const double* lanes) {
        const Doubles d;
        return {hn::LoadU(d, lanes), hn::LoadU(d, lanes + batchLanes), hn::LoadU(d, lanes + 2 * batchLanes),
                hn::LoadU(d, lanes + 3 * batchLanes)};
    }
    static HWY_INLINE void store(const Number& a, double* lanes) {
        const Doubles d;
        hn::Store(a.value, d, lanes);
        hn::Store(a.x, d, lanes + batchLanes);
        hn::Store(a.y, d, lanes + 2 * batchLanes);
        hn::Store(a.z, d, lanes + 3 * batchLanes);
    }
    static HWY_INLINE Uniform uniform(double value) { return {constantVector(value)}; }
    static HWY_INLINE Number widen(Uniform a) { return a; }

    /// A factor made finite: an infinite slope becomes a huge one of the same sign, NaN becomes 0.
    static HWY_INLINE Vector slope(Vector a) {
        const Vector limit = constantVector(GradientEvaluator::steepest);
        const Vector bounded = hn::Min(hn::Max(a, hn::Neg(limit)), limit);
        return hn::IfThenElseZero(hn::Eq(a, a), bounded);
    }
    /// The chain rule: `value` with the slope `factor` in `a`.
    static HWY_INLINE Number chain(const Number& a, Vector value, Vector factor) {
        return {value, hn::Mul(factor, a.x), hn::Mul(factor, a.y), hn::Mul(factor, a.z)};
    }
    /// The same for two operands.
    static HWY_INLINE Number chain(const Number& a, Vector fa, const Number& b, Vector fb, Vector value) {
        return {value, hn::Add(hn::Mul(fa, a.x), hn::Mul(fb, b.x)),
                hn::Add(hn::Mul(fa, a.y), hn::Mul(fb, b.y)), hn::Add(hn::Mul(fa, a.z), hn::Mul(fb, b.z))};
    }
    /// The same for a noise of three operands.
    static HWY_INLINE Number chain(const NoiseSample& noise, const Number& x, const Number& y,
                                   const Number& z) {
        const Number plane = chain(x, noise.x, y, noise.y, noise.value);
        return {noise.value, hn::MulAdd(noise.z, z.x, plane.x), hn::MulAdd(noise.z, z.y, plane.y),
                hn::MulAdd(noise.z, z.z, plane.z)};
    }
    /// The same where y does not move.
    static HWY_INLINE Number chain(const NoiseSample& noise, const Number& x, const Number& z) {
        return {noise.value, hn::MulAdd(noise.z, z.x, hn::Mul(noise.x, x.x)),
                hn::MulAdd(noise.z, z.y, hn::Mul(noise.x, x.y)),
                hn::MulAdd(noise.z, z.z, hn::Mul(noise.x, x.z))};
    }
    static HWY_INLINE Number flat(Vector value) { return FlatNumber{value}; }
    HWY_INLINE void begin(const TapeWorkspace&, std::size_t) {}
    /// Whether a lane holds one known value, so that a loop can run to it.
    static HWY_INLINE bool isExactLane(const double*) { return true; }
    /// The loop variable plus 1.
    static HWY_INLINE Number increment(const Number& a) { return add(a, uniform(1)); }
    static HWY_INLINE Number choose(Mask first, const Number& a, const Number& b) {
        return {hn::IfThenElse(first, a.value, b.value), hn::IfThenElse(first, a.x, b.x),
                hn::IfThenElse(first, a.y, b.y), hn::IfThenElse(first, a.z, b.z)};
    }
    static HWY_INLINE Vector one() { return constantVector(1); }
    /// Beyond its domain a function has no slope, even where the formula of the slope has a value.
    static HWY_INLINE Vector whereDefined(Vector value, Vector factor) {
        return hn::IfThenElseZero(hn::Eq(value, value), factor);
    }
    static HWY_INLINE Vector reciprocal(Vector a) { return slope(hn::Div(one(), a)); }

    static HWY_INLINE Number negate(const Number& a) {
        return {hn::Neg(a.value), hn::Neg(a.x), hn::Neg(a.y), hn::Neg(a.z)};
    }
    static HWY_INLINE Number absolute(const Number& a) {
        return chain(a, hn::Abs(a.value),
                     hn::IfThenElse(hn::Lt(a.value, hn::Zero(Doubles())), constantVector(-1), one()));
    }
    static HWY_INLINE Number square(const Number& a) {
        return chain(a, hn::Mul(a.value, a.value), hn::Add(a.value, a.value));
    }
    static HWY_INLINE Number squareRoot(const Number& a) {
        const Vector root = hn::Sqrt(a.value);
        return chain(a, root, slope(hn::Div(constantVector(0.5), root)));
    }
    static HWY_INLINE Number floor(const Number& a) { return flat(Point::floor(a.value)); }
    static HWY_INLINE Number ceiling(const Number& a) { return flat(Point::ceiling(a.value)); }
    static HWY_INLINE Number truncate(const Number& a) { return flat(Point::truncate(a.value)); }
    static HWY_INLINE Number fraction(const Number& a) { return {Point::fraction(a.value), a.x, a.y, a.z}; }
    static HWY_INLINE Number triangleWave(const Number& a) {
        const Mask rising =
            hn::Lt(hn::Sub(Point::fraction(a.value), constantVector(0.5)), hn::Zero(Doubles()));
        return chain(a, Point::triangleWave(a.value),
                     hn::IfThenElse(rising, constantVector(2), constantVector(-2)));
    }
    static HWY_INLINE Number cycle(const Number& a) {
        const Vector cosines = Point::cosine(Point::cycleAngle(a.value));
        return chain(a, Point::cycle(a.value), slope(hn::Mul(constantVector(2 * std::numbers::pi), cosines)));
    }
    static HWY_INLINE Number exponential(const Number& a) {
        const Vector value = Point::exponential(a.value);
        return chain(a, value, slope(value));
    }
    static HWY_INLINE Number naturalLogarithm(const Number& a) {
        const Vector value = Point::naturalLogarithm(a.value);
        return chain(a, value, whereDefined(value, reciprocal(a.value)));
    }
    static HWY_INLINE Number decimalLogarithm(const Number& a) {
        const Vector value = Point::decimalLogarithm(a.value);
        const Vector factor = hn::Mul(constantVector(0.43429448190325182765), reciprocal(a.value));
        return chain(a, value, whereDefined(value, factor));
    }
    static HWY_INLINE Number sine(const Number& a) {
        return chain(a, Point::sine(a.value), slope(Point::cosine(a.value)));
    }
    static HWY_INLINE Number cosine(const Number& a) {
        return chain(a, Point::cosine(a.value), slope(hn::Neg(Point::sine(a.value))));
    }
    static HWY_INLINE void sineAndCosine(const Number& a, Number& sines, Number& cosines) {
        const Vector s = Point::sine(a.value), c = Point::cosine(a.value);
        sines = chain(a, s, slope(c));
        cosines = chain(a, c, slope(hn::Neg(s)));
    }
    static HWY_INLINE Number tangent(const Number& a) {
        const Vector value = Point::tangent(a.value);
        return chain(a, value, slope(hn::Add(one(), hn::Mul(value, value))));
    }
    /// 1 / sqrt(1 - a^2), the slope of the arc sine.
    static HWY_INLINE Vector arcSlope(Vector a) {
        return reciprocal(hn::Sqrt(hn::Mul(hn::Sub(one(), a), hn::Add(one(), a))));
    }
    static HWY_INLINE Number arcSine(const Number& a) {
        return chain(a, Point::arcSine(a.value), arcSlope(a.value));
    }
    static HWY_INLINE Number arcCosine(const Number& a) {
        return chain(a, Point::arcCosine(a.value), hn::Neg(arcSlope(a.value)));
    }
    static HWY_INLINE Number arcTangent(const Number& a) {
        return chain(a, Point::arcTangent(a.value), reciprocal(hn::Add(one(), hn::Mul(a.value, a.value))));
    }
    static HWY_INLINE Number hyperbolicSine(const Number& a) {
        return chain(a, Point::hyperbolicSine(a.value), slope(Point::hyperbolicCosine(a.value)));
    }
    static HWY_INLINE Number hyperbolicCosine(const Number& a) {
        return chain(a, Point::hyperbolicCosine(a.value), slope(Point::hyperbolicSine(a.value)));
    }
    static HWY_INLINE Number hyperbolicTangent(const Number& a) {
        const Vector value = Point::hyperbolicTangent(a.value);
        return chain(a, value, slope(hn::Mul(hn::Sub(one(), value), hn::Add(one(), value))));
    }
    static HWY_INLINE Number areaSine(const Number& a) {
        const Vector root = hn::Sqrt(hn::Add(one(), hn::Mul(a.value, a.value)));
        return chain(a, Point::areaSine(a.value), reciprocal(root));
    }
    static HWY_INLINE Number areaCosine(const Number& a) {
        const Vector root = hn::Sqrt(hn::Mul(hn::Sub(a.value, one()), hn::Add(a.value, one())));
        const Vector value = Point::areaCosine(a.value);
        return chain(a, value, whereDefined(value, reciprocal(root)));
    }
    static HWY_INLINE Number areaTangent(const Number& a) {
        const Vector factor = reciprocal(hn::Mul(hn::Sub(one(), a.value), hn::Add(one(), a.value)));
        const Vector value = Point::areaTangent(a.value);
        return chain(a, value, whereDefined(value, factor));
    }

    static HWY_INLINE Number add(const Number& a, const Number& b) {
        return {hn::Add(a.value, b.value), hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
    }
    static HWY_INLINE Number add(const Number& a, Uniform b) {
        return {hn::Add(a.value, b.value), a.x, a.y, a.z};
    }
    static HWY_INLINE Number add(Uniform a, const Number& b) {
        return {hn::Add(a.value, b.value), b.x, b.y, b.z};
    }
    static HWY_INLINE Number subtract(const Number& a, const Number& b) {
        return {hn::Sub(a.value, b.value), hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
    }
    static HWY_INLINE Number subtract(const Number& a, Uniform b) {
        return {hn::Sub(a.value, b.value), a.x, a.y, a.z};
    }
    static HWY_INLINE Number subtract(Uniform a, const Number& b) {
        return {hn::Sub(a.value, b.value), hn::Neg(b.x), hn::Neg(b.y), hn::Neg(b.z)};
    }
    static HWY_INLINE Number multiply(const Number& a, const Number& b) {
        return chain(a, b.value, b, a.value, hn::Mul(a.value, b.value));
    }
    static HWY_INLINE Number multiply(const Number& a, Uniform b) {
        return chain(a, hn::Mul(a.value, b.value), b.value);
    }
    static HWY_INLINE Number multiply(Uniform a, const Number& b) { return multiply(b, a); }
    static HWY_INLINE Number divide(const Number& a, const Number& b) {
        const Vector quotient = hn::Div(a.value, b.value);
        const Vector inverse = reciprocal(b.value);
        return chain(a, inverse, b, hn::Neg(hn::Mul(slope(quotient), inverse)), quotient);
    }
    static HWY_INLINE Number divide(const Number& a, Uniform b) {
        return chain(a, hn::Div(a.value, b.value), reciprocal(b.value));
    }
    static HWY_INLINE Number power(const Number& a, const Number& b) {
        const Doubles d;
        const Vector value = Point::power(a.value, b.value);
        // d/da = b a^(b-1): through the value where it is not 0, by the definition where a is.
        const Vector direct = hn::Mul(b.value, Point::power(a.value, hn::Sub(b.value, one())));
        const Vector throughValue = hn::Div(hn::Mul(b.value, value), a.value);
        const Mask tame = normalWithin(a.value, 1e-300, 1e300);
        const Vector byBase = hn::IfThenElse(tame, throughValue, direct);
        // A power with exponent 0 is 1 everywhere, also at 0 where the formulas say 0 times infinity.
        const Vector baseSlope = hn::IfThenZeroElse(hn::Eq(b.value, hn::Zero(d)), slope(byBase));
        const Vector byExponent = slope(hn::Mul(value, Point::naturalLogarithm(a.value)));
        const Mask positive = hn::Gt(a.value, hn::Zero(d));
        return chain(a, baseSlope, b, hn::IfThenElseZero(positive, byExponent), value);
    }
    static HWY_INLINE Number arcTangent2(const Number& a, const Number& b) {
        const Vector square = hn::Add(hn::Mul(a.value, a.value), hn::Mul(b.value, b.value));
        return chain(a, slope(hn::Div(b.value, square)), b, slope(hn::Neg(hn::Div(a.value, square))),
                     Point::arcTangent2(a.value, b.value));
    }
    static HWY_INLINE Number remainder(const Number& a, const Number& b) {
        const Vector quotient = slope(hn::Trunc(hn::Div(a.value, b.value)));
        return chain(a, one(), b, hn::Neg(quotient), Point::remainder(a.value, b.value));
    }
    static HWY_INLINE Number minimum(const Number& a, const Number& b) {
        return choose(hn::Le(a.value, b.value), a, b);
    }
    static HWY_INLINE Number maximum(const Number& a, const Number& b) {
        return choose(hn::Lt(a.value, b.value), b, a);
    }
#define ISOSCOPE_FLAT(operation)                                           \
    static HWY_INLINE Number operation(const Number& a, const Number& b) { \
        return flat(Point::operation(a.value, b.value));                   \
    }
    ISOSCOPE_FLAT(integerDivide)
    ISOSCOPE_FLAT(equal)
    ISOSCOPE_FLAT(notEqual)
    ISOSCOPE_FLAT(less)
    ISOSCOPE_FLAT(lessEqual)
    ISOSCOPE_FLAT(greater)
    ISOSCOPE_FLAT(greaterEqual)
    ISOSCOPE_FLAT(logicalAnd)
    ISOSCOPE_FLAT(logicalOr)
#undef ISOSCOPE_FLAT

    static HWY_INLINE Number select3(const Number& a, const Number& b, const Number& c) {
        return choose(hn::Lt(a.value, hn::Zero(Doubles())), b, c);
    }
    static HWY_INLINE Number select4(const Number& a, const Number& b, const Number& c, const Number& d) {
        const Vector zero = hn::Zero(Doubles());
        return choose(hn::Lt(a.value, zero), b, choose(hn::Eq(a.value, zero), c, d));
    }

    /// noise() of a generator 0 to 3; of 0 to 2 also without lanes for a y of 0.
    static void noise(int generator, const std::array<const double*, 3>& place, std::size_t lanes,
                      double* target) {
        withNoiseKind(generator, place[1] == nullptr, [&](auto kind, auto ground) HWY_ATTR {
            noiseOf<kind(), ground()>(place, lanes, target);
        });
    }
    static void scalarOperation(const Instruction& instruction, const CrackleSettings* crackle,
                                const std::array<const double*, 4>& operands, double* target,
                                std::size_t lanes) {
        const double *a = operands[0], *b = operands[1], *c = operands[2];
        if (instruction.operation == Operation::noise) {
            evaluateNoise<GradientAlgebra>(operands[0], {operands[1], operands[2], operands[3]}, lanes,
                                           target);
        } else if (isVectorNoise(instruction.operation)) {
            NoiseColumns noise;
            latticeNoise<NoiseOrder::gradient>(noiseComponent(instruction.operation), {a, b, c}, lanes,
                                               allVectors, noise);
            for (std::size_t i = 0; i < lanes; i += vectorLanes)
                store(chain(noise.load(i), load(a + i), load(b + i), load(c + i)), target + i);
        } else {
            crackleLanes(*crackle, operands, target, lanes);
        }
    }

  private:
    template <int generator, bool ground>
    static HWY_NOINLINE void noiseOf(const std::array<const double*, 3>& place, std::size_t lanes,
                                     double* target) {
        constexpr NoiseOrder order = ground ? NoiseOrder::slopesXZ : NoiseOrder::gradient;
        NoiseColumns noise;
        rawNoise<order>(generator, place, lanes, allVectors, noise);
        for (std::size_t i = 0; i < lanes; i += vectorLanes) {
            const NoiseSample sample = finishedNoise<order>(generator, noise.load<order>(i));
            if constexpr (ground)
                store(chain(sample, load(place[0] + i), load(place[2] + i)), target + i);
            else
                store(chain(sample, load(place[0] + i), load(place[1] + i), load(place[2] + i)), target + i);
        }
    }

    static void crackleLanes(const CrackleSettings& crackle, const std::array<const double*, 4>& operands,
                             double* target, std::size_t lanes) {
        for (std::size_t i = 0; i < lanes; ++i) {
            std::array<double, 3> point, total{};
            for (std::size_t k = 0; k < 3; ++k) point[k] = operands[k][i];
            const std::array<double, 3> slopes =
                crackleGradient(crackle, point, GradientEvaluator::crackleStep);
            for (std::size_t axis = 0; axis < 3; ++axis)
                for (std::size_t k = 0; k < 3; ++k)
                    total[axis] += slopes[k] * operands[k][(axis + 1) * batchLanes + i];
            target[i] = evaluateOperation(Operation::crackle, point, &crackle);
            for (std::size_t axis = 0; axis < 3; ++axis) target[(axis + 1) * batchLanes + i] = total[axis];
        }
    }
};

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
