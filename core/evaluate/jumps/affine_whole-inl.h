// SPDX-License-Identifier: GPL-3.0-or-later
// Included once per instruction set. Affine forms on which whole numbers remain exact.
#if defined(ISOSCOPE_EVALUATE_AFFINE_WHOLE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOSCOPE_EVALUATE_AFFINE_WHOLE_INL
#undef ISOSCOPE_EVALUATE_AFFINE_WHOLE_INL
#else
#define ISOSCOPE_EVALUATE_AFFINE_WHOLE_INL
#endif

#include <hwy/highway.h>

#include <type_traits>

#include "core/evaluate/jumps/affine_cases.h"
#include "core/evaluate/algebra/affine_algebra-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

/// Sums, products and quotients that have no error where their operands are exact and the result is a double:
/// for algebras that keep the sides of jumps apart, so that a step of a step remains on it.
class AffineWholeAlgebra : public AffineAlgebra {
  public:
    /// Whether such an algebra has a rule of its own for it.
    static constexpr bool covers(Operation operation) {
        return hasSides(operation) || operation == Operation::add || operation == Operation::subtract ||
               operation == Operation::multiply || operation == Operation::divide;
    }
    /// Calls run() with the operation as a constant of the compiler; not for operations that are not covered.
    template <int number = 0, class Run>
    static HWY_INLINE void withCovered(Operation operation, const Run& run) {
        if constexpr (number < operationCount) {
            constexpr auto candidate = static_cast<Operation>(number);
            if constexpr (covers(candidate))
                if (operation == candidate) return run(std::integral_constant<Operation, candidate>());
            withCovered<number + 1>(operation, run);
        }
    }

  protected:
    /// Without an error where both are exact and their sum is a double: what is a step of a staircase remains
    /// on it. After Knuth's two-sum.
    static HWY_INLINE Number exactSum(const Number& p, const Number& q) {
        const Vector sum = hn::Add(p.a, q.a), part = hn::Sub(sum, p.a);
        const Vector lost = hn::Add(hn::Sub(p.a, hn::Sub(sum, part)), hn::Sub(q.a, part));
        const Mask exact = hn::And(hn::And(isExact(p), isExact(q)), hn::Eq(lost, zeroVector()));
        return chooseNumber(exact, exactNumber(sum), sumOf(p, q));
    }
    static HWY_INLINE Number exactProduct(const Number& p, const Number& q) {
        const Vector product = hn::Mul(p.a, q.a);
        const Mask exact = hn::And(hn::And(isExact(p), isExact(q)), isRemainderless(p.a, q.a, product));
        return chooseNumber(exact, exactNumber(product), productOf(p, q));
    }
    HWY_INLINE Number exactQuotient(const Number& p, const Number& q) const {
        // By one number for a lane: no worse than by a constant.
        const Mask divisible = hn::And(isExact(q), hn::Ne(q.a, zeroVector()));
        const Number byNumber = divide(p, Uniform{q.a});
        const Number quotient =
            hn::AllTrue(Doubles(), divisible) ? byNumber : chooseNumber(divisible, byNumber, divide(p, q));
        const Vector value = hn::Div(p.a, q.a);
        const Mask exact = hn::And(hn::And(isExact(p), divisible), isRemainderless(value, q.a, p.a));
        return chooseNumber(exact, exactNumber(value), quotient);
    }
    /// p / q, and p - q step for its step toward zero, exact where they are steps of steps.
    HWY_INLINE Number stepQuotient(const Number& p, const Number& q) const {
        if (HWY_LIKELY(hn::AllFalse(Doubles(), isExact(p)))) return quotientOf(p, q);
        return exactQuotient(p, q);
    }
    static HWY_INLINE Number stepRest(const Number& p, const Number& q, Vector step) {
        if (HWY_LIKELY(hn::AllFalse(Doubles(), isExact(p))))
            return differenceOf(p, productOf(q, exactNumber(step)));
        return exactSum(p, negated(exactProduct(q, exactNumber(step))));
    }
    /// Whether a b = product in real numbers; false as well where what is lost could get lost itself.
    static HWY_INLINE Mask isRemainderless(Vector a, Vector b, Vector product) {
        const Vector zero = zeroVector(), size = hn::Abs(product);
        const Mask moderate =
            hn::And(hn::Gt(size, constantVector(1e-200)), hn::Lt(size, constantVector(1e200)));
        const Mask nothing = hn::And(hn::Eq(product, zero), hn::Or(hn::Eq(a, zero), hn::Eq(b, zero)));
        return hn::Or(nothing, hn::And(moderate, hn::Eq(lostBy(a, b, product), zero)));
    }
    /// a b - product for their rounded product. After Dekker where there is no fused multiplication.
    static HWY_INLINE Vector lostBy(Vector a, Vector b, Vector product) {
#if HWY_NATIVE_FMA
        return hn::MulSub(a, b, product);
#else
        const auto high = [](Vector v) HWY_ATTR {
            const Vector scaled = hn::Mul(v, constantVector(134217729));
            return hn::Sub(scaled, hn::Sub(scaled, v));
        };
        const Vector highA = high(a), highB = high(b), lowA = hn::Sub(a, highA), lowB = hn::Sub(b, highB);
        const Vector first = hn::Sub(hn::Mul(highA, highB), product);
        const Vector second = hn::Add(hn::Add(first, hn::Mul(highA, lowB)), hn::Mul(lowA, highB));
        return hn::Add(second, hn::Mul(lowA, lowB));
#endif
    }

    /// `side` in the lanes of `read`, `hull()` in the others, if there are any.
    template <class Hull>
    static HWY_INLINE Number sideOr(Mask read, const Number& side, const Hull& hull) {
        if (HWY_LIKELY(hn::AllTrue(Doubles(), read))) return side;
        return chooseNumber(read, side, hull());
    }

    /// The range of an operand; of an exact one without the rounding of its ends.
    static HWY_INLINE VectorRange tight(const Number& p, const VectorRange& range) {
        const Mask exact = isExact(p);
        return {hn::IfThenElse(exact, p.a, range.low), hn::IfThenElse(exact, p.a, range.high)};
    }
};

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
