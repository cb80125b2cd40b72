// SPDX-License-Identifier: GPL-3.0-or-later
// Included once per instruction set. Elementary functions of affine forms: a straight line and the bounds of
// the rest. `domain` is what the operand can be at all, wherever the ray goes; it keeps the root of x*x + y*y
// defined.
#if defined(ISOSCOPE_EVALUATE_AFFINE_ELEMENTARY_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOSCOPE_EVALUATE_AFFINE_ELEMENTARY_INL
#undef ISOSCOPE_EVALUATE_AFFINE_ELEMENTARY_INL
#else
#define ISOSCOPE_EVALUATE_AFFINE_ELEMENTARY_INL
#endif

#include <hwy/highway.h>

#include <numbers>

#include "core/evaluate/algebra/affine_number-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

/// The vector functions' error: 1 ulp for SLEEF, up to 4 for Highway, 2 for the standard library.
constexpr double functionError = 8 * roundingUnit;
/// Highway's sine and cosine, and sineAndCosine(), are within 1e-15 of the truth up to largestAngle.
constexpr double angleError = 1e-15;

HWY_INLINE Vector relativeError(Vector value) {
    return hn::MulAdd(hn::Abs(value), constantVector(functionError), constantVector(underflow));
}

HWY_INLINE VectorRange clippedRange(const AffineNumber& p, const VectorRange& domain) {
    const VectorRange range = rangeOf(p);
    return {hn::Max(range.low, domain.low), hn::Min(range.high, domain.high)};
}

HWY_INLINE Mask noLane() { return hn::Lt(zeroVector(), zeroVector()); }

/// Where squares neither overflow nor underflow.
HWY_INLINE Mask moderateMagnitude(Vector a) { return normalWithin(a, 1e-140, 1e140); }
HWY_INLINE Mask notHuge(const VectorRange& range) {
    return hn::And(hn::Gt(range.low, constantVector(-1e100)), hn::Lt(range.high, constantVector(1e100)));
}

/// Between f(low) and f(high) of a rising function, library error included.
template <class Function>
HWY_INLINE AffineNumber risingBetween(const VectorRange& range, Function function) {
    const Vector low = function(range.low), high = function(range.high);
    return betweenNumber(hn::Sub(low, relativeError(low)), hn::Add(high, relativeError(high)));
}

/// `result` where the operand is inside the function's domain, undefined where it is outside, else unknown.
HWY_INLINE AffineNumber onDomain(Mask inside, Mask outside, const AffineNumber& result) {
    if (HWY_LIKELY(hn::AllTrue(Doubles(), inside))) return result;
    return chooseNumber(inside, result, chooseNumber(outside, undefinedNumber(), unknownNumber()));
}

HWY_INLINE AffineNumber absoluteOf(const AffineNumber& p) {
    const VectorRange range = rangeOf(p);
    const Mask positive = hn::Ge(range.low, zeroVector()), negative = hn::Le(range.high, zeroVector());
    const AffineNumber sure = chooseNumber(positive, p, negated(p));
    if (hn::AllTrue(Doubles(), hn::Or(positive, negative))) return sure;
    // Between the chord and its parallel through 0.
    const Vector width = hn::Div(constantVector(1), hn::Sub(range.high, range.low));
    const Vector slope = hn::Mul(hn::Add(range.high, range.low), width);
    const Vector rise = hn::Mul(hn::Mul(constantVector(-2), hn::Mul(range.low, width)), range.high);
    const AffineNumber mixed = lineWithRest(p, slope, zeroVector(), rise);
    return keepUnknown(p, chooseNumber(hn::Or(positive, negative), sure, mixed));
}

HWY_INLINE AffineNumber squareRootOf(const AffineNumber& p, const VectorRange& domain) {
    const VectorRange range = clippedRange(p, domain);
    const Vector first = hn::Sqrt(range.low), second = hn::Sqrt(range.high);
    const Vector sum = hn::Add(first, second);
    const Vector slope = hn::IfThenElseZero(hn::Gt(sum, zeroVector()), hn::Div(constantVector(1), sum));
    const AffineNumber line =
        lineWithRest(p, slope, hn::Mul(hn::Mul(first, slope), second), hn::Mul(sum, constantVector(0.25)));
    // A root that is not known to stay away from 0 has no useful line: its slope is not bounded.
    const AffineNumber flat = betweenNumber(hn::Mul(first, constantVector(1 - functionError)),
                                            hn::Mul(second, constantVector(1 + functionError)));
    const Mask inside = hn::Ge(range.low, zeroVector()), outside = hn::Lt(range.high, zeroVector());
    return keepUnknown(p, onDomain(inside, outside, narrower(line, flat)));
}

/// 1/p: for positive p between the chord and the tangent with its slope -1/(low high).
HWY_INLINE AffineNumber reciprocalOf(const AffineNumber& p, const VectorRange& domain) {
    const VectorRange range = clippedRange(p, domain);
    const Mask positive = hn::Gt(range.low, zeroVector());
    const Mask inside = hn::Or(positive, hn::Lt(range.high, zeroVector()));
    const Vector one = constantVector(1);
    const Vector first = hn::Div(one, hn::Abs(range.low)), second = hn::Div(one, hn::Abs(range.high));
    const Vector slope = hn::Neg(hn::Mul(first, second));
    const Vector tangent = hn::Mul(hn::Mul(constantVector(2), hn::Sqrt(first)), hn::Sqrt(second));
    const Vector chord = hn::Max(hn::Add(first, second), tangent);
    const Vector low = hn::IfThenElse(positive, tangent, hn::Neg(chord));
    const Vector high = hn::IfThenElse(positive, chord, hn::Neg(tangent));
    const AffineNumber line = lineWithRest(p, slope, low, high);
    // The slope must not underflow.
    const Mask moderate = hn::And(moderateMagnitude(range.low), moderateMagnitude(range.high));
    const Vector least = hn::IfThenElse(positive, second, hn::Neg(second));
    const Vector greatest = hn::IfThenElse(positive, first, hn::Neg(first));
    const AffineNumber flat =
        betweenNumber(hn::Sub(least, relativeError(least)), hn::Add(greatest, relativeError(greatest)));
    return keepUnknown(p, onDomain(inside, noLane(), chooseNumber(moderate, line, flat)));
}

/// The factor of r^2/2 that bounds exp(w) - 1 - w for |w| <= r <= 1.
HWY_INLINE Vector exponentialRest(Vector r) {
    const Vector growth = hn::MulAdd(hn::Add(r, constantVector(1)), r, constantVector(1));
    return hn::Mul(half(hn::Mul(r, r)), growth);
}

HWY_INLINE AffineNumber exponentialOf(const AffineNumber& p) {
    const Vector r = radiusOf(p);
    const Vector value = exponential(p.a);
    const AffineNumber line =
        developed(p, value, relativeError(value), value, zeroVector(), hn::Mul(value, exponentialRest(r)));
    const Mask small = hn::Le(r, constantVector(1));
    if (HWY_LIKELY(hn::AllTrue(Doubles(), small))) return keepUnknown(p, line);
    const AffineNumber flat = risingBetween(rangeOf(p), [](Vector v) HWY_ATTR { return exponential(v); });
    return keepUnknown(p, chooseNumber(small, line, flat));
}

HWY_INLINE AffineNumber logarithmOf(const AffineNumber& p, const VectorRange& domain) {
    const VectorRange range = clippedRange(p, domain);
    const Vector inverse = hn::Div(constantVector(1), p.a);
    const Vector z = hn::Mul(hn::Mul(radiusOf(p), inverse), constantVector(inflation));
    const Mask small = hn::And(hn::Gt(p.a, zeroVector()), hn::Le(z, constantVector(0.75)));
    // y - ln(1 + y) <= y^2/2 + |y|^3 / (3 (1 - |y|))
    const Vector cubic = hn::Div(z, hn::Mul(constantVector(3), hn::Sub(constantVector(1), z)));
    const Vector rest = hn::Mul(hn::Mul(z, z), hn::Add(constantVector(0.5), cubic));
    const Vector value = naturalLogarithm(hn::IfThenElse(small, p.a, constantVector(1)));
    const AffineNumber line = developed(p, value, relativeError(value), inverse, hn::Neg(rest), zeroVector());
    if (HWY_LIKELY(hn::AllTrue(Doubles(), small))) return keepUnknown(p, line);
    const AffineNumber flat = risingBetween(range, [](Vector v) HWY_ATTR { return naturalLogarithm(v); });
    const Mask inside = hn::Gt(range.low, zeroVector()), outside = hn::Lt(range.high, zeroVector());
    return keepUnknown(p, chooseNumber(small, line, onDomain(inside, outside, flat)));
}

/// Sine or cosine from value and slope at the centre; |f''| <= min(1, |f(a)| + r).
HWY_INLINE AffineNumber waveOf(const AffineNumber& p, Vector value, Vector slope) {
    const Vector one = constantVector(1);
    const Vector r = radiusOf(p);
    const Vector bend = hn::Min(one, hn::Add(hn::Add(hn::Abs(value), constantVector(angleError)), r));
    const Vector rest = hn::Mul(bend, half(hn::Mul(r, r)));
    const Vector error = hn::MulAdd(r, constantVector(angleError), constantVector(angleError));
    const AffineNumber line = developed(p, value, error, slope, hn::Neg(rest), rest);
    return keepUnknown(p, narrower(line, {zeroVector(), zeroVector(), one}));
}

/// Each is the slope of the other.
HWY_INLINE void waves(const AffineNumber& p, AffineNumber& sines, AffineNumber& cosines) {
    Vector s, c;
    sineAndCosine(p.a, s, c);
    sines = waveOf(p, s, c);
    cosines = waveOf(p, c, hn::Neg(s));
}
HWY_INLINE AffineNumber sineOf(const AffineNumber& p) {
    AffineNumber sines, cosines;
    waves(p, sines, cosines);
    return sines;
}
HWY_INLINE AffineNumber cosineOf(const AffineNumber& p) {
    AffineNumber sines, cosines;
    waves(p, sines, cosines);
    return cosines;
}

constexpr double turn = 2 * std::numbers::pi;
/// What the double `turn` misses of 2 pi.
constexpr double turnError = 2.5e-16;

/// sin(turn f) for the fraction f of p: sin(2 pi p) but for a turn that is rounded.
HWY_INLINE AffineNumber cycleOf(const AffineNumber& p) {
    const AffineNumber sines = sineOf(scaledBy(p, constantVector(turn)));
    const Vector size = hn::Add(hn::Abs(p.a), radiusOf(p));
    const Vector error = hn::Mul(hn::Add(size, constantVector(2)), constantVector(turnError));
    return {sines.a, sines.b, hn::MulAdd(sines.e, constantVector(inflation), error)};
}

/// 2 |p - c| around a whole number c, 1 less that around a half.
HWY_INLINE AffineNumber triangleWaveOf(const AffineNumber& p) {
    const Vector zero = zeroVector(), one = constantVector(1), two = constantVector(2);
    const Vector kink = half(hn::Round(hn::Add(p.a, p.a)));
    const AffineNumber away = differenceOf(p, exactNumber(kink));
    const VectorRange range = rangeOf(away);
    const Mask single =
        hn::And(hn::Ge(range.low, constantVector(-0.5)), hn::Le(range.high, constantVector(0.5)));
    const AffineNumber rising = scaledBy(absoluteOf(away), two);
    const AffineNumber falling = sumOf(negated(rising), AffineUniform{one});
    const AffineNumber wave = chooseNumber(hn::Eq(hn::Floor(kink), kink), rising, falling);
    return keepUnknown(p, chooseNumber(single, wave, betweenNumber(zero, one)));
}

/// tan(a + w) = y + (1 + y^2) tan(w) / (1 - y tan(w)), and tan(r) <= r + 0.4 r^3 up to 1/2.
HWY_INLINE AffineNumber tangentOf(const AffineNumber& p) {
    const Vector one = constantVector(1);
    const Vector r = radiusOf(p);
    const Vector value = tangent(p.a);
    const Vector steep = hn::MulAdd(value, value, one);
    const Vector excess = hn::Mul(constantVector(0.4), hn::Mul(r, hn::Mul(r, r)));
    const Vector t = hn::Add(r, excess);
    const Vector reach = hn::Mul(hn::Abs(value), t);
    const Vector rest = hn::Mul(steep, hn::Add(excess, hn::Div(hn::Mul(reach, t), hn::Sub(one, reach))));
    const AffineNumber line = developed(p, value, relativeError(value), steep, hn::Neg(rest), rest);
    const Mask inside = hn::And(hn::Le(r, constantVector(0.5)), hn::Lt(reach, constantVector(0.9)));
    return keepUnknown(p, onDomain(inside, noLane(), line));
}

/// A rising function on [-1, 1] (arc sine) with |f''| = X / (1 - X^2)^1.5.
HWY_INLINE AffineNumber arcSineOf(const AffineNumber& p, const VectorRange& domain) {
    const Vector one = constantVector(1);
    const VectorRange range = clippedRange(p, domain);
    const Vector farthest = hn::Max(hn::Abs(range.low), hn::Abs(range.high));
    const Mask inside = hn::Le(farthest, one);
    const Mask outside = hn::Or(hn::Gt(range.low, one), hn::Lt(range.high, constantVector(-1)));
    const auto safe = [&](Vector v) HWY_ATTR { return hn::IfThenElseZero(inside, v); };
    const Vector center = hn::Min(hn::Max(safe(p.a), constantVector(-1)), one);
    // The centre may lie outside the clipped range; the remainder lives between the two.
    const Vector last = hn::Max(farthest, hn::Abs(center));
    const Vector gap = hn::Mul(hn::Sub(one, last), hn::Add(one, last));
    const Vector bend = hn::Div(last, hn::Mul(gap, hn::Sqrt(gap)));
    const Vector r = radiusOf(p);
    const Vector rest = hn::Mul(bend, half(hn::Mul(r, r)));
    const Vector slope = hn::Div(one, hn::Sqrt(hn::Mul(hn::Sub(one, center), hn::Add(one, center))));
    const Vector value = arcSine(center);
    const AffineNumber line = developed(p, value, relativeError(value), slope, hn::Neg(rest), rest);
    const AffineNumber flat =
        risingBetween({safe(range.low), safe(range.high)}, [](Vector v) HWY_ATTR { return arcSine(v); });
    // The line is developed at p.a, which need not lie in the domain; then only the flat form holds.
    const Mask centered = hn::Lt(hn::Abs(p.a), one);
    const AffineNumber best = narrower(chooseNumber(centered, line, unknownNumber()), flat);
    return keepUnknown(p, onDomain(inside, outside, best));
}

HWY_INLINE AffineNumber arcCosineOf(const AffineNumber& p, const VectorRange& domain) {
    const AffineNumber turned = negated(arcSineOf(p, domain));
    const AffineNumber quarter{constantVector(std::numbers::pi / 2), zeroVector(),
                               constantVector(roundingUnit)};
    return keepUnknown(turned, sumOf(turned, quarter));
}

HWY_INLINE AffineNumber arcTangentOf(const AffineNumber& p) {
    const Vector one = constantVector(1);
    const Vector r = radiusOf(p);
    const Vector nearest = hn::Max(hn::Sub(hn::Abs(p.a), r), zeroVector());
    const Vector square = hn::MulAdd(nearest, nearest, one);
    const Vector bend =
        hn::IfThenElse(hn::Gt(nearest, constantVector(0.58)),
                       hn::Div(hn::Add(nearest, nearest), hn::Mul(square, square)), constantVector(0.65));
    const Vector rest = hn::Mul(hn::Mul(bend, constantVector(inflation)), half(hn::Mul(r, r)));
    const Vector value = arcTangent(p.a);
    const Vector slope = hn::Div(one, hn::MulAdd(p.a, p.a, one));
    const AffineNumber line = developed(p, value, relativeError(value), slope, hn::Neg(rest), rest);
    const AffineNumber flat = risingBetween(rangeOf(p), [](Vector v) HWY_ATTR { return arcTangent(v); });
    return keepUnknown(p, narrower(line, flat));
}

HWY_INLINE AffineNumber hyperbolicSineOf(const AffineNumber& p) {
    const Vector r = radiusOf(p);
    const Vector value = hyperbolicSine(p.a), slope = hyperbolicCosine(p.a);
    const Vector rest = hn::Mul(slope, exponentialRest(r));
    const AffineNumber line = developed(p, value, relativeError(value), slope, hn::Neg(rest), rest);
    const Mask small = hn::Le(r, constantVector(1));
    if (HWY_LIKELY(hn::AllTrue(Doubles(), small))) return keepUnknown(p, line);
    const AffineNumber flat = risingBetween(rangeOf(p), [](Vector v) HWY_ATTR { return hyperbolicSine(v); });
    return keepUnknown(p, chooseNumber(small, line, flat));
}

HWY_INLINE AffineNumber hyperbolicCosineOf(const AffineNumber& p) {
    const Vector r = radiusOf(p);
    const Vector value = hyperbolicCosine(p.a), slope = hyperbolicSine(p.a);
    const Vector rest = hn::Mul(value, exponentialRest(r));
    const AffineNumber line = developed(p, value, relativeError(value), slope, hn::Neg(rest), rest);
    const Mask small = hn::Le(r, constantVector(1));
    if (HWY_LIKELY(hn::AllTrue(Doubles(), small))) return keepUnknown(p, line);
    const VectorRange range = rangeOf(p);
    const Vector farthest = hyperbolicCosine(hn::Max(hn::Abs(range.low), hn::Abs(range.high)));
    const AffineNumber flat = betweenNumber(constantVector(1), hn::Add(farthest, relativeError(farthest)));
    return keepUnknown(p, chooseNumber(small, line, flat));
}

HWY_INLINE AffineNumber hyperbolicTangentOf(const AffineNumber& p) {
    const Vector one = constantVector(1);
    const Vector r = radiusOf(p);
    const Vector value = hyperbolicTangent(p.a);
    const Vector slope = hn::Mul(hn::Sub(one, value), hn::Add(one, value));
    // |f''| <= 4 sqrt(3) / 9; the slope is a difference and has an absolute error.
    const Vector rest = hn::Mul(constantVector(0.77), half(hn::Mul(r, r)));
    const Vector error = hn::MulAdd(r, constantVector(2 * functionError), relativeError(value));
    const AffineNumber line = developed(p, value, error, slope, hn::Neg(rest), rest);
    const AffineNumber flat =
        risingBetween(rangeOf(p), [](Vector v) HWY_ATTR { return hyperbolicTangent(v); });
    return keepUnknown(p, narrower(line, flat));
}

HWY_INLINE AffineNumber areaSineOf(const AffineNumber& p) {
    const Vector one = constantVector(1);
    const Vector r = radiusOf(p);
    const Vector nearest = hn::Max(hn::Sub(hn::Abs(p.a), r), zeroVector());
    // |f''| = x / (1 + x^2)^1.5 <= min(0.385, 1/x^2)
    const Vector bend =
        hn::Min(constantVector(0.385), hn::Div(constantVector(inflation), hn::Mul(nearest, nearest)));
    const Vector rest = hn::Mul(bend, half(hn::Mul(r, r)));
    const Vector value = areaSine(p.a);
    const Vector slope = hn::Div(one, hn::Sqrt(hn::MulAdd(p.a, p.a, one)));
    const AffineNumber line = developed(p, value, relativeError(value), slope, hn::Neg(rest), rest);
    const VectorRange range = rangeOf(p);
    const AffineNumber flat = risingBetween(range, [](Vector v) HWY_ATTR { return areaSine(v); });
    return keepUnknown(p, chooseNumber(notHuge(range), narrower(line, flat), flat));
}

HWY_INLINE AffineNumber areaCosineOf(const AffineNumber& p, const VectorRange& domain) {
    const Vector one = constantVector(1);
    const VectorRange range = clippedRange(p, domain);
    const Mask inside = hn::Ge(range.low, one), outside = hn::Lt(range.high, one);
    const auto safe = [&](Vector v) HWY_ATTR { return hn::IfThenElse(inside, v, one); };
    const auto gap = [&](Vector v) HWY_ATTR { return hn::Mul(hn::Sub(v, one), hn::Add(v, one)); };
    const Vector r = radiusOf(p);
    const Vector low = safe(range.low), center = hn::Max(safe(p.a), one);
    // The centre may lie outside the clipped range; the remainder lives between the two.
    const Vector first = hn::Min(low, center);
    const Vector bend = hn::Div(first, hn::Mul(gap(first), hn::Sqrt(gap(first))));
    const Vector rest = hn::Mul(bend, half(hn::Mul(r, r)));
    const Vector value = areaCosine(center);
    const Vector slope = hn::Div(one, hn::Sqrt(gap(center)));
    const AffineNumber line = developed(p, value, relativeError(value), slope, hn::Neg(rest), zeroVector());
    const AffineNumber flat =
        risingBetween({low, safe(range.high)}, [](Vector v) HWY_ATTR { return areaCosine(v); });
    const Mask centered = hn::And(hn::Gt(p.a, one), notHuge(range));
    const AffineNumber best = narrower(chooseNumber(centered, line, unknownNumber()), flat);
    return keepUnknown(p, onDomain(inside, outside, best));
}

HWY_INLINE AffineNumber areaTangentOf(const AffineNumber& p, const VectorRange& domain) {
    const Vector one = constantVector(1);
    const VectorRange range = clippedRange(p, domain);
    const Vector farthest = hn::Max(hn::Abs(range.low), hn::Abs(range.high));
    const Mask inside = hn::Lt(farthest, one);
    const Mask outside = hn::Or(hn::Gt(range.low, one), hn::Lt(range.high, constantVector(-1)));
    const auto safe = [&](Vector v) HWY_ATTR { return hn::IfThenElseZero(inside, v); };
    const auto gap = [&](Vector v) HWY_ATTR { return hn::Mul(hn::Sub(one, v), hn::Add(one, v)); };
    const Vector r = radiusOf(p);
    const Vector center = safe(p.a);
    const Vector last = hn::Max(safe(farthest), hn::Abs(center));
    const Vector edge = gap(last);
    const Vector rest = hn::Mul(hn::Div(last, hn::Mul(edge, edge)), hn::Mul(r, r));
    const Vector value = areaTangent(center);
    const AffineNumber line =
        developed(p, value, relativeError(value), hn::Div(one, gap(center)), hn::Neg(rest), rest);
    const AffineNumber flat =
        risingBetween({safe(range.low), safe(range.high)}, [](Vector v) HWY_ATTR { return areaTangent(v); });
    const Mask centered = hn::Lt(hn::Abs(p.a), one);
    const AffineNumber best = narrower(chooseNumber(centered, line, unknownNumber()), flat);
    return keepUnknown(p, onDomain(inside, outside, best));
}

/// Whether a point of the plane stays off the negative half of the axis of abscissas, for all that can be
/// told from where its ordinate may be 0.
HWY_INLINE Mask staysOffCut(const AffineNumber& ordinate, const AffineNumber& abscissa) {
    const Vector one = constantVector(1), minusOne = constantVector(-1);
    const auto rounding = [](const AffineNumber& p) HWY_ATTR {
        return hn::Mul(hn::Add(hn::Abs(p.a), hn::Abs(p.b)), constantVector(8 * roundingUnit));
    };
    const Vector inverse = hn::Div(one, ordinate.b);
    const Vector middle = hn::Neg(hn::Mul(ordinate.a, inverse));
    const Vector width = hn::MulAdd(hn::Add(ordinate.e, rounding(ordinate)), hn::Abs(inverse),
                                    constantVector(8 * roundingUnit));
    const Vector first = hn::Sub(middle, width), last = hn::Add(middle, width);
    const Mask never = hn::Or(hn::Gt(first, one), hn::Lt(last, minusOne));
    const Vector low = hn::MulAdd(abscissa.b, hn::Max(first, minusOne), abscissa.a),
                 high = hn::MulAdd(abscissa.b, hn::Min(last, one), abscissa.a);
    const Vector reach = hn::MulAdd(abscissa.e, constantVector(inflation), rounding(abscissa));
    return hn::And(hn::Gt(hn::Abs(ordinate.b), constantVector(underflow)),
                   hn::Or(never, hn::Gt(hn::Min(low, high), reach)));
}

/// The angle of a point that moves along a straight line, give or take a distance that moves it by no more
/// than its share of what is left to the origin. At the distance r from the origin, along a line at the
/// distance d from it and with the speed v, the second derivative is 2 d v^2 sqrt(r^2 - d^2) / r^4, which is
/// largest, 3 sqrt(3)/8 (v/d)^2, at r^2 = 4/3 d^2.
HWY_INLINE AffineNumber arcTangent2Of(const AffineNumber& ordinate, const AffineNumber& abscissa) {
    const VectorRange y = rangeOf(ordinate), x = rangeOf(abscissa);
    const Vector zero = zeroVector(), one = constantVector(1);
    const AffineNumber halfTurn = {zero, zero, constantVector(std::numbers::pi * (1 + functionError))};
    const Mask beside = hn::And(hn::Le(x.low, zero), hn::And(hn::Le(y.low, zero), hn::Ge(y.high, zero)));
    const Mask cut =
        hn::AllFalse(Doubles(), beside) ? beside : hn::AndNot(staysOffCut(ordinate, abscissa), beside);
    // In parts of the distance of the middle.
    const Vector distance = hn::Sqrt(hn::MulAdd(ordinate.a, ordinate.a, hn::Mul(abscissa.a, abscissa.a)));
    const Vector part = hn::Div(one, distance);
    const Vector ya = hn::Mul(ordinate.a, part), yb = hn::Mul(ordinate.b, part),
                 ye = hn::Mul(ordinate.e, part);
    const Vector xa = hn::Mul(abscissa.a, part), xb = hn::Mul(abscissa.b, part),
                 xe = hn::Mul(abscissa.e, part);
    const Vector slope = hn::MulSub(xa, yb, hn::Mul(ya, xb));
    const Vector speedSquare = hn::MulAdd(xb, xb, hn::Mul(yb, yb)), speed = hn::Sqrt(speedSquare);
    const Vector along = hn::MulAdd(xa, xb, hn::Mul(ya, yb));
    const Vector moving = hn::IfThenElseZero(hn::Gt(speedSquare, zero), hn::Div(along, speedSquare));
    const Vector nearest = hn::Neg(hn::Min(hn::Max(moving, constantVector(-1)), one));
    const Vector nearX = hn::MulAdd(nearest, xb, xa), nearY = hn::MulAdd(nearest, yb, ya);
    const Vector rounding = hn::Mul(hn::Add(one, speed), constantVector(64 * roundingUnit));
    const Vector rho = hn::Sub(hn::Sqrt(hn::MulAdd(nearX, nearX, hn::Mul(nearY, nearY))), rounding);
    const Vector steepest = hn::Add(hn::Abs(slope), rounding);
    const Vector rhoSquare = hn::Mul(rho, rho), slopeSquare = hn::Mul(steepest, steepest);
    const Vector beyond = hn::MulSub(speedSquare, rhoSquare, slopeSquare);
    const Mask isFar = hn::Gt(beyond, hn::Mul(slopeSquare, constantVector(0.334)));
    const Vector farBend =
        hn::Div(hn::Mul(hn::Add(steepest, steepest), hn::Sqrt(beyond)), hn::Mul(rhoSquare, rhoSquare));
    const Vector mostBend =
        hn::Div(hn::Mul(constantVector(0.65), hn::Mul(speedSquare, speedSquare)), slopeSquare);
    const Vector bend = hn::Mul(hn::IfThenElse(isFar, farBend, mostBend), constantVector(1 + 1e-8));
    const Vector strayed = hn::Sqrt(hn::MulAdd(xe, xe, hn::Mul(ye, ye)));
    const Vector left = hn::Sub(rho, hn::Mul(strayed, constantVector(inflation)));
    const Vector value = arcTangent2(ordinate.a, abscissa.a);
    const Vector error =
        hn::Add(hn::Add(relativeError(value), rounding),
                hn::Add(half(hn::IfThenElseZero(hn::Gt(speed, zero), bend)), hn::Div(strayed, left)));
    const AffineNumber line{value, slope, hn::Mul(error, constantVector(inflation))};
    const Mask clear = hn::Gt(left, hn::Mul(hn::Add(one, speed), constantVector(1e-6)));
    const Mask smooth = hn::And(hn::AndNot(cut, clear), moderateMagnitude(distance));
    return keepUnknown(ordinate, abscissa, chooseNumber(smooth, narrower(line, halfTurn), halfTurn));
}

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
