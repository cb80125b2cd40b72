// SPDX-License-Identifier: GPL-3.0-or-later
// Included once per instruction set. Affine forms in one variable and the linear part of their arithmetic.
#if defined(ISOSCOPE_EVALUATE_AFFINE_NUMBER_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOSCOPE_EVALUATE_AFFINE_NUMBER_INL
#undef ISOSCOPE_EVALUATE_AFFINE_NUMBER_INL
#else
#define ISOSCOPE_EVALUATE_AFFINE_NUMBER_INL
#endif

#include <hwy/highway.h>

#include <limits>

#include "core/evaluate/algebra/point_algebra-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

// Arithmetic rounds to nearest with a relative error of at most 2^-53 an operation. Every rule adds what its
// own roundings can amount to, with some to spare for the rounding of the sum itself.
constexpr double roundingUnit = 1.2e-16;
/// Makes up for roundings in the computation of an error term.
constexpr double inflation = 1 + 32 * roundingUnit;
/// More than any product loses by underflow.
constexpr double underflow = std::numeric_limits<double>::min();
constexpr double unlimited = std::numeric_limits<double>::infinity();

/// A number that is the same and exact in all lanes.
struct AffineUniform {
    Vector a;
};

/// The values a + b s + [-e, e] for s in [-1, 1], the position along a piece of a ray.
///
/// e = +infinity or NaN: nothing is known, not even whether there is a value ("unknown").
/// e = -infinity: there is certainly no value ("undefined"). In both cases a and b mean nothing.
struct AffineNumber {
    Vector a, b, e;

    AffineNumber() = default;
    // One vector after the other: what is copied as a whole the compiler keeps in memory as well.
    AffineNumber(const AffineNumber& p) : a(p.a), b(p.b), e(p.e) {}
    AffineNumber& operator=(const AffineNumber&) = default;
    HWY_INLINE AffineNumber(Vector center, Vector slope, Vector error) : a(center), b(slope), e(error) {}
    /// NaN is undefined, infinity unknown.
    HWY_INLINE AffineNumber(AffineUniform uniform) : a(uniform.a), b(hn::Zero(Doubles())) {
        const Vector limit = constantVector(unlimited);
        const Vector special = hn::IfThenElse(hn::Eq(a, a), limit, hn::Neg(limit));
        e = hn::IfThenElse(hn::Lt(hn::Abs(a), limit), hn::Zero(Doubles()), special);
    }
};

struct VectorRange {
    Vector low, high;
};

HWY_INLINE Vector zeroVector() { return hn::Zero(Doubles()); }
HWY_INLINE Vector half(Vector a) { return hn::Mul(a, constantVector(0.5)); }

HWY_INLINE Mask isKnown(const AffineNumber& p) { return hn::Lt(hn::Abs(p.e), constantVector(unlimited)); }
HWY_INLINE Mask isUndefined(const AffineNumber& p) { return hn::Eq(p.e, constantVector(-unlimited)); }
HWY_INLINE Mask isUnknown(const AffineNumber& p) { return hn::Not(hn::Or(isKnown(p), isUndefined(p))); }
/// One exact value.
HWY_INLINE Mask isExact(const AffineNumber& p) {
    return hn::And(hn::Eq(p.b, zeroVector()), hn::Eq(p.e, zeroVector()));
}

HWY_INLINE AffineNumber unknownNumber() { return {zeroVector(), zeroVector(), constantVector(unlimited)}; }
HWY_INLINE AffineNumber undefinedNumber() { return {zeroVector(), zeroVector(), constantVector(-unlimited)}; }
HWY_INLINE AffineNumber exactNumber(Vector value) { return {value, zeroVector(), zeroVector()}; }

HWY_INLINE AffineNumber chooseNumber(Mask first, const AffineNumber& p, const AffineNumber& q) {
    return {hn::IfThenElse(first, p.a, q.a), hn::IfThenElse(first, p.b, q.b),
            hn::IfThenElse(first, p.e, q.e)};
}

/// How far the values are from a, rounded up.
HWY_INLINE Vector radiusOf(const AffineNumber& p) {
    return hn::Mul(hn::Add(hn::Abs(p.b), p.e), constantVector(inflation));
}

/// All values, rounded outwards. Only of known numbers.
HWY_INLINE VectorRange rangeOf(const AffineNumber& p) {
    const Vector reach = hn::MulAdd(hn::Abs(p.a), constantVector(2 * roundingUnit), radiusOf(p));
    return {hn::Sub(p.a, reach), hn::Add(p.a, reach)};
}

/// How far the farther of two ends is from the center: what half of a number loses below the normal ones,
/// all of the smallest, is then no loss.
HWY_INLINE Vector reachFrom(Vector center, Vector low, Vector high) {
    return hn::Max(hn::Sub(high, center), hn::Sub(center, low));
}

/// A number somewhere between two others (each rounded outwards already).
HWY_INLINE AffineNumber betweenNumber(Vector low, Vector high) {
    const Vector center = half(hn::Add(low, high));
    const Vector error = hn::MulAdd(reachFrom(center, low, high), constantVector(inflation),
                                    hn::Mul(hn::Abs(center), constantVector(2 * roundingUnit)));
    return {center, zeroVector(), error};
}

/// A line for the values of a function, or their plain range where the line is not much better: what a line
/// is worth is how little it leaves open beside its slope.
HWY_INLINE AffineNumber narrower(const AffineNumber& line, const AffineNumber& flat) {
    return chooseNumber(hn::Le(line.e, half(flat.e)), line, flat);
}

/// What a function makes of numbers that are not known: the same.
HWY_INLINE AffineNumber keepUnknown(const AffineNumber& operand, const AffineNumber& result) {
    return {result.a, result.b, hn::IfThenElse(isKnown(operand), result.e, operand.e)};
}
HWY_INLINE AffineNumber keepUnknown(const AffineNumber& p, const AffineNumber& q,
                                    const AffineNumber& result) {
    const Mask known = hn::And(isKnown(p), isKnown(q));
    if (HWY_LIKELY(hn::AllTrue(Doubles(), known))) return result;
    const Mask undefined = hn::Or(isUndefined(p), isUndefined(q));
    const Vector e = hn::IfThenElse(undefined, constantVector(-unlimited), constantVector(unlimited));
    return {result.a, result.b, hn::IfThenElse(known, result.e, e)};
}

HWY_INLINE AffineNumber negated(const AffineNumber& p) { return {hn::Neg(p.a), hn::Neg(p.b), p.e}; }

HWY_INLINE AffineNumber sumOf(const AffineNumber& p, const AffineNumber& q) {
    const Vector a = hn::Add(p.a, q.a), b = hn::Add(p.b, q.b);
    const Vector rounding = hn::Mul(hn::Add(hn::Abs(a), hn::Abs(b)), constantVector(roundingUnit));
    return {a, b, hn::MulAdd(hn::Add(p.e, q.e), constantVector(inflation), rounding)};
}
HWY_INLINE AffineNumber sumOf(const AffineNumber& p, AffineUniform c) {
    const Vector a = hn::Add(p.a, c.a);
    return {a, p.b,
            hn::MulAdd(p.e, constantVector(inflation), hn::Mul(hn::Abs(a), constantVector(roundingUnit)))};
}
HWY_INLINE AffineNumber differenceOf(const AffineNumber& p, const AffineNumber& q) {
    const Vector a = hn::Sub(p.a, q.a), b = hn::Sub(p.b, q.b);
    const Vector rounding = hn::Mul(hn::Add(hn::Abs(a), hn::Abs(b)), constantVector(roundingUnit));
    return {a, b, hn::MulAdd(hn::Add(p.e, q.e), constantVector(inflation), rounding)};
}

HWY_INLINE AffineNumber scaledBy(const AffineNumber& p, Vector factor) {
    const Vector a = hn::Mul(p.a, factor), b = hn::Mul(p.b, factor);
    const Vector rounding =
        hn::MulAdd(hn::Add(hn::Abs(a), hn::Abs(b)), constantVector(roundingUnit), constantVector(underflow));
    const Vector e = hn::MulAdd(hn::Mul(p.e, hn::Abs(factor)), constantVector(inflation), rounding);
    return keepUnknown(p, {a, b, e});
}

/// (a1 + b1 s)(a2 + b2 s) with s^2 = 1/2 +- 1/2.
HWY_INLINE AffineNumber productOf(const AffineNumber& p, const AffineNumber& q) {
    const Vector bb = half(hn::Mul(p.b, q.b));
    const Vector a = hn::Add(hn::Mul(p.a, q.a), bb);
    const Vector b = hn::Add(hn::Mul(p.a, q.b), hn::Mul(p.b, q.a));
    const Vector m1 = hn::Add(hn::Abs(p.a), hn::Abs(p.b)), m2 = hn::Add(hn::Abs(q.a), hn::Abs(q.b));
    const Vector cross = hn::MulAdd(hn::Add(m2, q.e), p.e, hn::Mul(m1, q.e));
    const Vector rounding =
        hn::MulAdd(hn::Mul(m1, m2), constantVector(6 * roundingUnit), constantVector(underflow));
    const Vector e = hn::MulAdd(hn::Add(hn::Abs(bb), cross), constantVector(inflation), rounding);
    return keepUnknown(p, q, {a, b, e});
}

HWY_INLINE AffineNumber squareOf(const AffineNumber& p) {
    const Vector bb = half(hn::Mul(p.b, p.b));
    const Vector a = hn::MulAdd(p.a, p.a, bb);
    const Vector ab = hn::Mul(p.a, p.b);
    const Vector m = hn::Add(hn::Abs(p.a), hn::Abs(p.b));
    const Vector cross = hn::Mul(hn::Add(hn::Add(m, m), p.e), p.e);
    const Vector rounding =
        hn::MulAdd(hn::Mul(m, m), constantVector(6 * roundingUnit), constantVector(underflow));
    const Vector e = hn::MulAdd(hn::Add(bb, cross), constantVector(inflation), rounding);
    return keepUnknown(p, {a, hn::Add(ab, ab), e});
}

/// slope * p + [low, high]: what is left when a function is replaced by a straight line.
HWY_INLINE AffineNumber lineWithRest(const AffineNumber& p, Vector slope, Vector low, Vector high) {
    const Vector a = hn::MulAdd(slope, p.a, half(hn::Add(low, high)));
    const Vector b = hn::Mul(slope, p.b);
    const Vector size = hn::Abs(slope);
    const Vector magnitude =
        hn::MulAdd(size, hn::Add(hn::Abs(p.a), radiusOf(p)), hn::Add(hn::Abs(low), hn::Abs(high)));
    const Vector rounding =
        hn::MulAdd(magnitude, constantVector(8 * roundingUnit), constantVector(underflow));
    const Vector error = hn::MulAdd(size, p.e, half(hn::Sub(high, low)));
    return {a, b, hn::MulAdd(error, constantVector(inflation), rounding)};
}

/// value + slope * (p - p.a) + [low, high], where value has the error `valueError` and slope a relative error
/// of at most 8 units: a function developed at p.a with the bounds of its remainder.
HWY_INLINE AffineNumber developed(const AffineNumber& p, Vector value, Vector valueError, Vector slope,
                                  Vector low, Vector high) {
    const Vector a = hn::Add(value, half(hn::Add(low, high)));
    const Vector b = hn::Mul(slope, p.b);
    const Vector size = hn::Abs(slope);
    const Vector magnitude = hn::MulAdd(hn::Mul(size, radiusOf(p)), constantVector(4),
                                        hn::Add(hn::Abs(value), hn::Add(hn::Abs(low), hn::Abs(high))));
    const Vector rounding =
        hn::MulAdd(magnitude, constantVector(4 * roundingUnit), constantVector(underflow));
    const Vector error = hn::Add(hn::MulAdd(size, p.e, half(hn::Sub(high, low))), valueError);
    return {a, b, hn::MulAdd(error, constantVector(inflation), rounding)};
}

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
