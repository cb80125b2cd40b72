// SPDX-License-Identifier: GPL-3.0-or-later
// Included once per instruction set. Intervals with the lower end negated, so that rounding upwards rounds
// both ends outwards. Everything here runs with the rounding mode set upwards.
#if defined(ISOSCOPE_EVALUATE_INTERVAL_NUMBER_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOSCOPE_EVALUATE_INTERVAL_NUMBER_INL
#undef ISOSCOPE_EVALUATE_INTERVAL_NUMBER_INL
#else
#define ISOSCOPE_EVALUATE_INTERVAL_NUMBER_INL
#endif

#include <hwy/highway.h>

#include <cfenv>
#include <limits>

#include "core/evaluate/algebra/point_algebra-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

constexpr double endless = std::numeric_limits<double>::infinity();

/// A number that is the same in all lanes.
struct IntervalUniform {
    Vector value;
};

/// The values from -minusLow to high; `doubt` is not 0 where there may be no value
/// (Interval::maybeUndefined). Certainly no value: both ends -infinity.
struct IntervalNumber {
    Vector high, minusLow, doubt;

    IntervalNumber() = default;
    HWY_INLINE IntervalNumber(Vector h, Vector n, Vector u) : high(h), minusLow(n), doubt(u) {}
    /// NaN has no value; of infinity nothing is known.
    HWY_INLINE IntervalNumber(IntervalUniform uniform) {
        const Vector limit = constantVector(endless), value = uniform.value;
        const Mask finite = hn::Lt(hn::Abs(value), limit);
        const Vector special = hn::IfThenElse(hn::Eq(value, value), limit, hn::Neg(limit));
        high = hn::IfThenElse(finite, value, special);
        minusLow = hn::IfThenElse(finite, hn::Neg(value), special);
        doubt = hn::IfThenElse(finite, hn::Zero(Doubles()), constantVector(1));
    }
};

HWY_INLINE Vector lowOf(const IntervalNumber& p) { return hn::Neg(p.minusLow); }
HWY_INLINE Vector noDoubt() { return hn::Zero(Doubles()); }
HWY_INLINE Vector inDoubt() { return constantVector(1); }
HWY_INLINE Mask isEmpty(const IntervalNumber& p) { return hn::Not(hn::Le(lowOf(p), p.high)); }
HWY_INLINE Mask isSure(const IntervalNumber& p) { return hn::Eq(p.doubt, noDoubt()); }
HWY_INLINE Mask isBounded(const IntervalNumber& p) {
    const Vector limit = constantVector(endless);
    return hn::And(hn::Lt(hn::Abs(p.high), limit), hn::Lt(hn::Abs(p.minusLow), limit));
}

HWY_INLINE IntervalNumber unknownInterval() {
    return {constantVector(endless), constantVector(endless), inDoubt()};
}
HWY_INLINE IntervalNumber emptyInterval() {
    return {constantVector(-endless), constantVector(-endless), inDoubt()};
}
HWY_INLINE IntervalNumber chooseInterval(Mask first, const IntervalNumber& p, const IntervalNumber& q) {
    return {hn::IfThenElse(first, p.high, q.high), hn::IfThenElse(first, p.minusLow, q.minusLow),
            hn::IfThenElse(first, p.doubt, q.doubt)};
}
HWY_INLINE IntervalNumber hullOf(const IntervalNumber& p, const IntervalNumber& q) {
    return {hn::Max(p.high, q.high), hn::Max(p.minusLow, q.minusLow), hn::Or(p.doubt, q.doubt)};
}
HWY_INLINE IntervalNumber negated(const IntervalNumber& p) { return {p.minusLow, p.high, p.doubt}; }

/// An end that came to NaN (infinity minus infinity) is not known.
HWY_INLINE Vector knownEnd(Vector end) {
    return hn::IfThenElse(hn::Eq(end, end), end, constantVector(endless));
}

/// For results that are not all bounded: what has no value stays so, and NaN says nothing.
HWY_NOINLINE inline IntervalNumber repaired(Mask empty, const IntervalNumber& result) {
    const Mask number = hn::And(hn::Eq(result.high, result.high), hn::Eq(result.minusLow, result.minusLow));
    const Vector doubt = hn::IfThenElse(number, result.doubt, inDoubt());
    return chooseInterval(empty, emptyInterval(), {knownEnd(result.high), knownEnd(result.minusLow), doubt});
}

HWY_INLINE IntervalNumber sumOf(const IntervalNumber& p, const IntervalNumber& q) {
    const IntervalNumber sum{hn::Add(p.high, q.high), hn::Add(p.minusLow, q.minusLow),
                             hn::Or(p.doubt, q.doubt)};
    if (HWY_LIKELY(hn::AllTrue(Doubles(), isBounded(sum)))) return sum;
    return repaired(hn::Or(isEmpty(p), isEmpty(q)), sum);
}

/// The largest of four products; 0 times infinity is 0, for an infinite end stands for numbers without limit.
HWY_INLINE Vector largest(Vector a, Vector b, Vector c, Vector d) {
    return hn::Max(hn::Max(a, b), hn::Max(c, d));
}

HWY_NOINLINE inline IntervalNumber endlessProduct(const IntervalNumber& p, const IntervalNumber& q) {
    const auto product = [](Vector a, Vector b) HWY_ATTR {
        const Vector value = hn::Mul(a, b);
        return hn::IfThenElseZero(hn::Eq(value, value), value);
    };
    const Vector pl = lowOf(p), ql = lowOf(q);
    const IntervalNumber result{
        largest(product(p.high, q.high), product(pl, ql), product(pl, q.high), product(p.high, ql)),
        largest(product(p.minusLow, q.high), product(p.high, q.minusLow), product(hn::Neg(p.high), q.high),
                product(pl, q.minusLow)),
        hn::Or(p.doubt, q.doubt)};
    return chooseInterval(hn::Or(isEmpty(p), isEmpty(q)), emptyInterval(), result);
}

HWY_INLINE IntervalNumber productOf(const IntervalNumber& p, const IntervalNumber& q) {
    if (HWY_UNLIKELY(!hn::AllTrue(Doubles(), hn::And(isBounded(p), isBounded(q)))))
        return endlessProduct(p, q);
    const Vector pl = lowOf(p), ql = lowOf(q), minusHigh = hn::Neg(p.high);
    return {largest(hn::Mul(p.high, q.high), hn::Mul(p.minusLow, q.minusLow), hn::Mul(pl, q.high),
                    hn::Mul(p.high, ql)),
            largest(hn::Mul(p.minusLow, q.high), hn::Mul(p.high, q.minusLow), hn::Mul(minusHigh, q.high),
                    hn::Mul(pl, q.minusLow)),
            hn::Or(p.doubt, q.doubt)};
}

/// Distance from 0: all values of |p|.
HWY_INLINE IntervalNumber absoluteOf(const IntervalNumber& p) {
    const Vector zero = hn::Zero(Doubles());
    const Mask positive = hn::Le(p.minusLow, zero), negative = hn::Le(p.high, zero);
    const IntervalNumber around{hn::Max(p.high, p.minusLow), zero, p.doubt};
    const IntervalNumber result = chooseInterval(positive, p, chooseInterval(negative, negated(p), around));
    return chooseInterval(isEmpty(p), p, result);
}

HWY_INLINE IntervalNumber squareOf(const IntervalNumber& p) {
    const IntervalNumber size = absoluteOf(p);
    const IntervalNumber square{hn::Mul(size.high, size.high), hn::Mul(size.minusLow, lowOf(size)), p.doubt};
    return chooseInterval(isEmpty(p), p, square);
}

HWY_INLINE IntervalNumber quotientOf(const IntervalNumber& p, const IntervalNumber& q) {
    const Vector one = constantVector(1);
    const Mask away = hn::Or(hn::Lt(q.minusLow, hn::Zero(Doubles())), hn::Lt(q.high, hn::Zero(Doubles())));
    // The ends change places, and each is rounded outwards: 1/low upwards, -(1/high) upwards.
    const IntervalNumber inverse{hn::Div(one, lowOf(q)), hn::Div(hn::Neg(one), q.high), q.doubt};
    const Mask empty = hn::Or(isEmpty(p), isEmpty(q));
    const IntervalNumber result = productOf(p, chooseInterval(away, inverse, {one, one, q.doubt}));
    if (HWY_LIKELY(hn::AllTrue(Doubles(), hn::AndNot(empty, away)))) return result;
    return chooseInterval(empty, emptyInterval(), chooseInterval(away, result, unknownInterval()));
}

/// The part of p in [low, high], where a function is defined.
HWY_INLINE IntervalNumber restricted(const IntervalNumber& p, double low, double high) {
    const Vector minusLow = constantVector(-low), top = constantVector(high);
    const Mask inside = hn::And(hn::Le(p.minusLow, minusLow), hn::Le(p.high, top));
    if (HWY_LIKELY(hn::AllTrue(Doubles(), inside))) return p;
    const IntervalNumber part{hn::Min(p.high, top), hn::Min(p.minusLow, minusLow),
                              hn::IfThenElse(inside, p.doubt, inDoubt())};
    return chooseInterval(isEmpty(part), emptyInterval(), part);
}

HWY_INLINE IntervalNumber squareRootOf(const IntervalNumber& p) {
    const IntervalNumber part = restricted(p, 0, endless);
    // The root is rounded upwards too; a unit less is below the lower end.
    const Vector low = hn::Mul(hn::Sqrt(lowOf(part)), constantVector(-(1 - 4e-16)));
    return chooseInterval(isEmpty(part), part, {hn::Sqrt(part.high), low, part.doubt});
}

/// Sets the mode for the code of library functions, which is made for rounding to nearest. What is computed
/// must pass through memory on both sides (see throughMemory): the compiler knows nothing of rounding modes.
class NearestRounding {
  public:
    NearestRounding() { std::fesetround(FE_TONEAREST); }
    ~NearestRounding() { std::fesetround(FE_UPWARD); }
    NearestRounding(const NearestRounding&) = delete;
    NearestRounding& operator=(const NearestRounding&) = delete;
};

HWY_INLINE void keepInPlace(double* lanes) { asm volatile("" : : "r"(lanes) : "memory"); }

/// function(a, b) in rounding to nearest.
template <class Function>
HWY_NOINLINE void atNearest(Vector& a, Vector& b, Function function) {
    const Doubles d;
    HWY_ALIGN double lanes[2 * HWY_MAX_BYTES / sizeof(double)];
    double* second = lanes + HWY_MAX_BYTES / sizeof(double);
    hn::Store(a, d, lanes);
    hn::Store(b, d, second);
    {
        const NearestRounding nearest;
        keepInPlace(lanes);
        Vector first = hn::Load(d, lanes), last = hn::Load(d, second);
        function(first, last);
        hn::Store(first, d, lanes);
        hn::Store(last, d, second);
        keepInPlace(lanes);
    }
    keepInPlace(lanes);
    a = hn::Load(d, lanes);
    b = hn::Load(d, second);
}

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
