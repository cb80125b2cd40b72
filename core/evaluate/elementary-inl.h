// SPDX-License-Identifier: GPL-3.0-or-later
// Included once per instruction set. Elementary functions of vectors: within 1e-15 relative (1e-15 absolute
// for sine and cosine) of the standard library, and the standard library itself wherever the vector function
// has no exact answer for special arguments. Which way a lane goes depends on that lane alone.
#if defined(ISOSCOPE_EVALUATE_ELEMENTARY_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOSCOPE_EVALUATE_ELEMENTARY_INL
#undef ISOSCOPE_EVALUATE_ELEMENTARY_INL
#else
#define ISOSCOPE_EVALUATE_ELEMENTARY_INL
#endif

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

#include <cmath>
#include <limits>

#include "core/evaluate/sleef-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

using Mask = hn::Mask<Doubles>;

HWY_INLINE Vector constantVector(double value) { return hn::Set(Doubles(), value); }

/// Replaces the lanes of `result` where `accepted` is false by function(a).
template <class Scalar>
HWY_NOINLINE Vector mend(Mask accepted, Vector result, Vector a, Scalar function) {
    return hn::IfThenElse(accepted, result,
                          laneByLane(function, hn::IfThenElse(accepted, constantVector(1), a)));
}

template <class Scalar>
HWY_NOINLINE Vector mend(Mask accepted, Vector result, Vector a, Vector b, Scalar function) {
    const Vector one = constantVector(1);
    return hn::IfThenElse(
        accepted, result,
        laneByLane(function, hn::IfThenElse(accepted, one, a), hn::IfThenElse(accepted, one, b)));
}

/// fast(a) where `safe`, exact(a) elsewhere; `fast` only ever sees safe numbers (`stand` in place of others).
template <class Fast, class Scalar>
HWY_INLINE Vector guarded(Vector a, Mask safe, double stand, Fast fast, Scalar exact) {
    if (HWY_LIKELY(hn::AllTrue(Doubles(), safe))) return fast(a);
    return mend(safe, fast(hn::IfThenElse(safe, a, constantVector(stand))), a, exact);
}

HWY_INLINE Mask within(Vector a, double bound) { return hn::Le(hn::Abs(a), constantVector(bound)); }
HWY_INLINE Mask between(Vector a, double low, double high) {
    return hn::And(hn::Ge(a, constantVector(low)), hn::Le(a, constantVector(high)));
}

constexpr double smallestNormal = std::numeric_limits<double>::min();
constexpr double largestFinite = std::numeric_limits<double>::max();
/// Highway reduces arguments by four parts of pi; to here the product with the first is exact.
constexpr double largestAngle = 30000;
/// To here SLEEF's tangent takes one and the same reduction whatever the other lanes hold.
constexpr double largestTangentAngle = 14.5;

// clang-format off
HWY_INLINE Vector sine(Vector a) {
    // The polynomial loses the sign of -0.
    const auto fast = [](Vector v) HWY_ATTR {
        return hn::IfThenElse(hn::Eq(v, hn::Zero(Doubles())), v, hn::Sin(Doubles(), v));
    };
    return guarded(a, within(a, largestAngle), 0, fast, [](double x) { return std::sin(x); });
}
HWY_INLINE Vector cosine(Vector a) {
    return guarded(a, within(a, largestAngle), 0, [](Vector v) HWY_ATTR { return hn::Cos(Doubles(), v); },
                   [](double x) { return std::cos(x); });
}
HWY_INLINE Vector tangent(Vector a) {
    return guarded(a, within(a, largestTangentAngle), 0, [](Vector v) HWY_ATTR { return sleefTan(v); },
                   [](double x) { return std::tan(x); });
}
HWY_INLINE Vector arcSine(Vector a) {
    return guarded(a, within(a, 1), 0, [](Vector v) HWY_ATTR { return sleefAsin(v); },
                   [](double x) { return std::asin(x); });
}
HWY_INLINE Vector arcCosine(Vector a) {
    return guarded(a, within(a, 1), 0, [](Vector v) HWY_ATTR { return sleefAcos(v); },
                   [](double x) { return std::acos(x); });
}
HWY_INLINE Vector arcTangent(Vector a) {
    return guarded(a, within(a, largestFinite), 0, [](Vector v) HWY_ATTR { return sleefAtan(v); },
                   [](double x) { return std::atan(x); });
}
HWY_INLINE Vector exponential(Vector a) {
    return guarded(a, within(a, 700), 0, [](Vector v) HWY_ATTR { return sleefExp(v); },
                   [](double x) { return std::exp(x); });
}
HWY_INLINE Vector naturalLogarithm(Vector a) {
    return guarded(a, between(a, smallestNormal, largestFinite), 1, [](Vector v) HWY_ATTR { return sleefLog(v); },
                   [](double x) { return std::log(x); });
}
HWY_INLINE Vector decimalLogarithm(Vector a) {
    return guarded(a, between(a, smallestNormal, largestFinite), 1, [](Vector v) HWY_ATTR { return sleefLog10(v); },
                   [](double x) { return std::log10(x); });
}
HWY_INLINE Vector hyperbolicSine(Vector a) {
    return guarded(a, within(a, 700), 0, [](Vector v) HWY_ATTR { return sleefSinh(v); },
                   [](double x) { return std::sinh(x); });
}
HWY_INLINE Vector hyperbolicCosine(Vector a) {
    return guarded(a, within(a, 700), 0, [](Vector v) HWY_ATTR { return sleefCosh(v); },
                   [](double x) { return std::cosh(x); });
}
HWY_INLINE Vector hyperbolicTangent(Vector a) {
    return guarded(a, within(a, 700), 0, [](Vector v) HWY_ATTR { return sleefTanh(v); },
                   [](double x) { return std::tanh(x); });
}
HWY_INLINE Vector areaSine(Vector a) {
    return guarded(a, within(a, 1e150), 0, [](Vector v) HWY_ATTR { return sleefAsinh(v); },
                   [](double x) { return std::asinh(x); });
}
HWY_INLINE Vector areaCosine(Vector a) {
    return guarded(a, between(a, 1, 1e150), 1, [](Vector v) HWY_ATTR { return sleefAcosh(v); },
                   [](double x) { return std::acosh(x); });
}
HWY_INLINE Vector areaTangent(Vector a) {
    const Mask inside = hn::Lt(hn::Abs(a), constantVector(1));
    return guarded(a, inside, 0, [](Vector v) HWY_ATTR { return sleefAtanh(v); },
                   [](double x) { return std::atanh(x); });
}
// clang-format on

HWY_INLINE Mask normalWithin(Vector a, double low, double high) { return between(hn::Abs(a), low, high); }

HWY_INLINE Vector power(Vector base, Vector exponent) {
    const Doubles d;
    const Mask operandsSafe = hn::And(normalWithin(base, 1e-300, 1e300), within(exponent, 1e9));
    const Vector one = constantVector(1);
    const Vector fast =
        sleefPow(hn::IfThenElse(operandsSafe, base, one), hn::IfThenElse(operandsSafe, exponent, one));
    const Mask safe = hn::And(operandsSafe, normalWithin(fast, 1e-300, 1e300));
    if (HWY_LIKELY(hn::AllTrue(d, safe))) return fast;
    return mend(safe, fast, base, exponent, [](double x, double y) { return std::pow(x, y); });
}

HWY_INLINE Vector arcTangent2(Vector ordinate, Vector abscissa) {
    const Doubles d;
    const Mask safe = hn::And(normalWithin(ordinate, 1e-150, 1e150), normalWithin(abscissa, 1e-150, 1e150));
    const Vector one = constantVector(1);
    if (HWY_LIKELY(hn::AllTrue(d, safe))) return sleefAtan2(ordinate, abscissa);
    const Vector fast = sleefAtan2(hn::IfThenElse(safe, ordinate, one), hn::IfThenElse(safe, abscissa, one));
    return mend(safe, fast, ordinate, abscissa, [](double y, double x) { return std::atan2(y, x); });
}

/// fmod, exactly: with a fused multiply-add a - q b is exact when q is the truncated quotient or one more.
HWY_INLINE Vector remainder(Vector a, Vector b) {
    const auto exact = [](double x, double y) { return std::fmod(x, y); };
#if HWY_NATIVE_FMA
    const Doubles d;
    const Vector divisor = hn::Abs(b);
    const Vector dividend = hn::Abs(a);
    const Mask safe =
        hn::And(hn::And(normalWithin(b, 1e-150, 1e300), hn::Le(dividend, constantVector(1e300))),
                hn::Lt(dividend, hn::Mul(divisor, constantVector(1e15))));
    const Vector quotient = hn::Trunc(hn::Div(dividend, divisor));
    Vector rest = hn::NegMulAdd(quotient, divisor, dividend);
    rest = hn::IfThenElse(hn::Lt(rest, hn::Zero(d)), hn::Add(rest, divisor), rest);
    const Vector fast = hn::CopySign(rest, a);
    if (HWY_LIKELY(hn::AllTrue(d, safe))) return fast;
    return mend(safe, fast, a, b, exact);
#else
    return laneByLane(exact, a, b);
#endif
}

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
