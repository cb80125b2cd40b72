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

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/evaluate/algebra/sleef-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

using Mask = hn::Mask<Doubles>;

HWY_INLINE Vector constantVector(double value) { return hn::Set(Doubles(), value); }

/// Calls replace(lane) for the lanes where `accepted` is false; a few as a rule.
template <class Replace>
HWY_INLINE void forRejected(Mask accepted, Replace replace) {
    const Doubles d;
    std::array<std::uint8_t, 8> bits{};
    hn::StoreMaskBits(d, accepted, bits.data());
    for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane)
        if ((bits[lane / 8] >> lane % 8 & 1) == 0) replace(lane);
}

/// Replaces the lanes of `result` where `accepted` is false by function(a).
template <class Scalar>
HWY_NOINLINE Vector mend(Mask accepted, Vector result, Vector a, Scalar function) {
    const Doubles d;
    HWY_ALIGN double operands[HWY_MAX_BYTES / sizeof(double)], results[HWY_MAX_BYTES / sizeof(double)];
    hn::Store(a, d, operands);
    hn::Store(result, d, results);
    forRejected(accepted, [&](std::size_t lane) { results[lane] = function(operands[lane]); });
    return hn::Load(d, results);
}

template <class Scalar>
HWY_NOINLINE Vector mend(Mask accepted, Vector result, Vector a, Vector b, Scalar function) {
    const Doubles d;
    constexpr std::size_t most = HWY_MAX_BYTES / sizeof(double);
    HWY_ALIGN double first[most], second[most], results[most];
    hn::Store(a, d, first);
    hn::Store(b, d, second);
    hn::Store(result, d, results);
    forRejected(accepted, [&](std::size_t lane) { results[lane] = function(first[lane], second[lane]); });
    return hn::Load(d, results);
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
    // The polynomial is about a quarter turn, where that of 0 is rounded.
    const auto fast = [](Vector v) HWY_ATTR {
        return hn::IfThenElse(within(v, 1e-8), constantVector(1), hn::Cos(Doubles(), v));
    };
    return guarded(a, within(a, largestAngle), 0, fast, [](double x) { return std::cos(x); });
}
/// Both, for little more than the price of one; each is within 1e-15. Highway's parts of pi/2, whose products
/// with the quadrant are exact as far as they count, and the polynomials of fdlibm for |angle| <= pi/4.
HWY_INLINE void sineAndCosine(Vector a, Vector& sines, Vector& cosines) {
    const Doubles d;
    const hn::RebindToUnsigned<Doubles> bits;
    const Mask safe = within(a, largestAngle);
    const Vector angle = hn::IfThenElseZero(safe, a);
    // Added to this, numbers lose what is behind the point.
    const Vector large = constantVector(6755399441055744.0);
    const Vector turned = hn::MulAdd(angle, constantVector(0.63661977236758134308), large);
    const Vector quadrant = hn::Sub(turned, large);
    Vector x = hn::MulAdd(quadrant, constantVector(-0.5 * 3.1415926218032836914), angle);
    x = hn::MulAdd(quadrant, constantVector(-0.5 * 3.1786509424591713469e-8), x);
    x = hn::MulAdd(quadrant, constantVector(-0.5 * 1.2246467864107188502e-16), x);
    const Vector y = hn::Mul(x, x);
    Vector s = constantVector(1.58969099521155010221e-10), c = constantVector(-1.13596475577881948265e-11);
    for (const double term : {-2.50507602534068634195e-08, 2.75573137070700676789e-06, -1.98412698298579493134e-04,
                              8.33333333332248946124e-03, -1.66666666666666324348e-01})
        s = hn::MulAdd(s, y, constantVector(term));
    for (const double term : {2.08757232129817482790e-09, -2.75573143513906633035e-07, 2.48015872894767294178e-05,
                              -1.38888888888741095749e-03, 4.16666666666666019037e-02, -0.5, 1.0})
        c = hn::MulAdd(c, y, constantVector(term));
    s = hn::MulAdd(hn::Mul(x, y), s, x);
    const auto number = hn::BitCast(bits, turned);
    const auto one = hn::Set(bits, 1), two = hn::Set(bits, 2);
    const Mask odd = hn::MaskFromVec(hn::BitCast(d, hn::VecFromMask(bits, hn::Eq(hn::And(number, one), one))));
    const auto sign = [&](auto quarter) HWY_ATTR {
        return hn::BitCast(d, hn::ShiftLeft<62>(hn::And(quarter, two)));
    };
    sines = hn::Xor(hn::IfThenElse(odd, c, s), sign(number));
    cosines = hn::Xor(hn::IfThenElse(odd, s, c), sign(hn::Add(number, one)));
    if (HWY_LIKELY(hn::AllTrue(d, safe))) return;
    sines = mend(safe, sines, a, [](double v) { return std::sin(v); });
    cosines = mend(safe, cosines, a, [](double v) { return std::cos(v); });
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

/// roughPower() is as close to the power as this, in parts of it.
constexpr double roughPowerError = 1e-12;

/// A positive number to any power, by its logarithm: half the price of power(). The error of the logarithm,
/// 1.5 units of at most 700, is one of the result in parts of it.
HWY_INLINE Vector roughPower(Vector base, Vector exponent) {
    const Doubles d;
    const Mask normal = normalWithin(base, smallestNormal, largestFinite);
    if (HWY_LIKELY(hn::AllTrue(d, normal))) {
        const Vector product = hn::Mul(exponent, sleefLog(base));
        if (HWY_LIKELY(hn::AllTrue(d, within(product, 700)))) return sleefExp(product);
    }
    return power(base, exponent);
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
