// SPDX-License-Identifier: GPL-3.0-or-later
// Included once per instruction set. The operations of a function graph on vectors of plain numbers; the
// meaning is that of evaluateOperation, lane by lane.
#if defined(ISOSCOPE_EVALUATE_POINT_ALGEBRA_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOSCOPE_EVALUATE_POINT_ALGEBRA_INL
#undef ISOSCOPE_EVALUATE_POINT_ALGEBRA_INL
#else
#define ISOSCOPE_EVALUATE_POINT_ALGEBRA_INL
#endif

#include <hwy/highway.h>

#include <array>
#include <numbers>

#include "core/evaluate/algebra/elementary-inl.h"
#include "core/evaluate/tape/tape_workspace.h"
#include "core/function/scalar_operations.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

/// Numbers of the point evaluator. A uniform operand is the same type.
struct PointAlgebra {
    using Number = Vector;
    using Uniform = Vector;
    static constexpr std::size_t components = 1;
    /// Whether pairs of sums and products are run as one.
    static constexpr bool fuses = true;

    static HWY_INLINE Number load(const double* lanes) { return hn::LoadU(Doubles(), lanes); }
    static HWY_INLINE void store(Number a, double* lanes) { hn::Store(a, Doubles(), lanes); }
    static HWY_INLINE Uniform uniform(double value) { return constantVector(value); }
    static HWY_INLINE Number widen(Uniform a) { return a; }
    HWY_INLINE void begin(const TapeWorkspace&, std::size_t) {}
    /// Whether a lane holds one known value, so that a loop can run to it.
    static HWY_INLINE bool isExactLane(const double*) { return true; }
    /// The loop variable plus 1.
    static HWY_INLINE Number increment(const Number& a) { return add(a, uniform(1)); }
    static HWY_INLINE Number choose(Mask first, Number a, Number b) { return hn::IfThenElse(first, a, b); }

    static HWY_INLINE Vector truth(Mask mask) { return hn::IfThenElseZero(mask, constantVector(1)); }
    // hn::Ne says false to NaN on some instruction sets.
    static HWY_INLINE Mask nonZero(Vector a) { return hn::Not(hn::Eq(a, hn::Zero(Doubles()))); }
    static HWY_INLINE Vector truncate32(Vector a) {
        const Mask fits =
            hn::And(hn::Gt(a, constantVector(-2147483649.0)), hn::Lt(a, constantVector(2147483648.0)));
        // Adding 0 makes -0 positive, as the way through an integer does.
        const Vector whole = hn::Add(hn::Trunc(a), hn::Zero(Doubles()));
        return hn::IfThenElse(fits, whole, constantVector(-2147483648.0));
    }

    static HWY_INLINE Vector negate(Vector a) { return hn::Neg(a); }
    static HWY_INLINE Vector absolute(Vector a) { return hn::Abs(a); }
    static HWY_INLINE Vector square(Vector a) { return hn::Mul(a, a); }
    static HWY_INLINE Vector squareRoot(Vector a) { return hn::Sqrt(a); }
#if HWY_TARGET == HWY_SCALAR || HWY_TARGET == HWY_EMU128 || HWY_TARGET == HWY_SSE2
    // Highway's own go through integers there and lose the sign of zeros.
    static HWY_INLINE Vector floor(Vector a) { return hn::CopySign(hn::Floor(a), a); }
    static HWY_INLINE Vector ceiling(Vector a) { return hn::CopySign(hn::Ceil(a), a); }
#else
    static HWY_INLINE Vector floor(Vector a) { return hn::Floor(a); }
    static HWY_INLINE Vector ceiling(Vector a) { return hn::Ceil(a); }
#endif
    static HWY_INLINE Vector truncate(Vector a) { return truncate32(a); }
    static HWY_INLINE Vector fraction(Vector a) { return hn::Sub(a, floor(a)); }
    static HWY_INLINE Vector triangleWave(Vector a) {
        const Vector part = fraction(a), rest = hn::Sub(constantVector(1), part);
        const Mask rising = hn::Lt(hn::Sub(part, constantVector(0.5)), hn::Zero(Doubles()));
        return hn::Mul(constantVector(2), hn::IfThenElse(rising, part, rest));
    }
    /// 2 pi times the fraction of |a|.
    static HWY_INLINE Vector cycleAngle(Vector a) {
        return hn::Mul(constantVector(2 * std::numbers::pi), fraction(hn::Abs(a)));
    }
    static HWY_INLINE Vector cycle(Vector a) {
        const Vector sines = sine(cycleAngle(a));
        return hn::IfThenElse(hn::Lt(a, hn::Zero(Doubles())), hn::Neg(sines), sines);
    }
    static HWY_INLINE Vector exponential(Vector a) { return HWY_NAMESPACE::exponential(a); }
    static HWY_INLINE Vector naturalLogarithm(Vector a) { return HWY_NAMESPACE::naturalLogarithm(a); }
    static HWY_INLINE Vector decimalLogarithm(Vector a) { return HWY_NAMESPACE::decimalLogarithm(a); }
    static HWY_INLINE Vector sine(Vector a) { return HWY_NAMESPACE::sine(a); }
    static HWY_INLINE Vector cosine(Vector a) { return HWY_NAMESPACE::cosine(a); }
    static HWY_INLINE Vector tangent(Vector a) { return HWY_NAMESPACE::tangent(a); }
    static HWY_INLINE Vector arcSine(Vector a) { return HWY_NAMESPACE::arcSine(a); }
    static HWY_INLINE Vector arcCosine(Vector a) { return HWY_NAMESPACE::arcCosine(a); }
    static HWY_INLINE Vector arcTangent(Vector a) { return HWY_NAMESPACE::arcTangent(a); }
    static HWY_INLINE Vector hyperbolicSine(Vector a) { return HWY_NAMESPACE::hyperbolicSine(a); }
    static HWY_INLINE Vector hyperbolicCosine(Vector a) { return HWY_NAMESPACE::hyperbolicCosine(a); }
    static HWY_INLINE Vector hyperbolicTangent(Vector a) { return HWY_NAMESPACE::hyperbolicTangent(a); }
    static HWY_INLINE Vector areaSine(Vector a) { return HWY_NAMESPACE::areaSine(a); }
    static HWY_INLINE Vector areaCosine(Vector a) { return HWY_NAMESPACE::areaCosine(a); }
    static HWY_INLINE Vector areaTangent(Vector a) { return HWY_NAMESPACE::areaTangent(a); }

    static HWY_INLINE Vector add(Vector a, Vector b) { return hn::Add(a, b); }
    static HWY_INLINE Vector subtract(Vector a, Vector b) { return hn::Sub(a, b); }
    static HWY_INLINE Vector multiply(Vector a, Vector b) { return hn::Mul(a, b); }
    static HWY_INLINE Vector divide(Vector a, Vector b) { return hn::Div(a, b); }
    static HWY_INLINE Vector power(Vector a, Vector b) { return HWY_NAMESPACE::power(a, b); }
    static HWY_INLINE Vector arcTangent2(Vector a, Vector b) { return HWY_NAMESPACE::arcTangent2(a, b); }
    static HWY_INLINE Vector remainder(Vector a, Vector b) { return HWY_NAMESPACE::remainder(a, b); }
    static HWY_INLINE Vector integerDivide(Vector a, Vector b) { return truncate32(hn::Div(a, b)); }
    // hn::Min and hn::Max do not promise which operand a NaN or a zero of the other sign gives.
    static HWY_INLINE Vector minimum(Vector a, Vector b) { return hn::IfThenElse(hn::Le(a, b), a, b); }
    static HWY_INLINE Vector maximum(Vector a, Vector b) { return hn::IfThenElse(hn::Lt(a, b), b, a); }
    static HWY_INLINE Vector equal(Vector a, Vector b) { return truth(hn::Eq(a, b)); }
    static HWY_INLINE Vector notEqual(Vector a, Vector b) { return truth(hn::Not(hn::Eq(a, b))); }
    static HWY_INLINE Vector less(Vector a, Vector b) { return truth(hn::Lt(a, b)); }
    static HWY_INLINE Vector lessEqual(Vector a, Vector b) { return truth(hn::Le(a, b)); }
    static HWY_INLINE Vector greater(Vector a, Vector b) { return truth(hn::Not(hn::Le(a, b))); }
    static HWY_INLINE Vector greaterEqual(Vector a, Vector b) { return truth(hn::Not(hn::Lt(a, b))); }
    static HWY_INLINE Vector logicalAnd(Vector a, Vector b) { return truth(hn::And(nonZero(a), nonZero(b))); }
    static HWY_INLINE Vector logicalOr(Vector a, Vector b) { return truth(hn::Or(nonZero(a), nonZero(b))); }

    static HWY_INLINE Vector select3(Vector a, Vector b, Vector c) {
        return hn::IfThenElse(hn::Lt(a, hn::Zero(Doubles())), b, c);
    }
    static HWY_INLINE Vector select4(Vector a, Vector b, Vector c, Vector d) {
        const Vector zero = hn::Zero(Doubles());
        return hn::IfThenElse(hn::Lt(a, zero), b, hn::IfThenElse(hn::Eq(a, zero), c, d));
    }

    /// The `wanted` components of the vector noise for `lanes` lanes, each into a target of its own, of which
    /// the last may be the memory of a coordinate.
    static void vectorNoise(std::span<const int> wanted, const std::array<const double*, 3>& place,
                            const std::array<double*, 3>& targets, std::size_t lanes);
    /// Noise and crackle: `lanes` is the number of lanes to compute.
    /// noise() of a generator 0 to 3; of 0 to 2 also without lanes for a y of 0.
    static void noise(int generator, const std::array<const double*, 3>& place, std::size_t lanes,
                      double* target);
    static void scalarOperation(const Instruction& instruction, const CrackleSettings* crackle,
                                const std::array<const double*, 4>& operands, double* target,
                                std::size_t lanes);
};

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
