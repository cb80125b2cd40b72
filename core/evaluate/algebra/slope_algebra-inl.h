// SPDX-License-Identifier: GPL-3.0-or-later
// Included once per instruction set. Affine forms with the slope along the ray and the rounding of points.
#if defined(ISOSCOPE_EVALUATE_SLOPE_ALGEBRA_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOSCOPE_EVALUATE_SLOPE_ALGEBRA_INL
#undef ISOSCOPE_EVALUATE_SLOPE_ALGEBRA_INL
#else
#define ISOSCOPE_EVALUATE_SLOPE_ALGEBRA_INL
#endif

#include <hwy/highway.h>

#include "core/evaluate/algebra/affine_algebra-inl.h"
#include "core/evaluate/algebra/slope_operations.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

/// Values as an affine form; their derivative by t, which lies in slope +- spread all along the piece (where
/// there is none, all slopes to the left and to the right do); and how far what the point evaluator makes of
/// any point of the piece is from the truth. Infinite or NaN: not known.
struct SlopeNumber {
    AffineNumber value;
    Vector slope, spread, rounding;

    SlopeNumber() = default;
    HWY_INLINE SlopeNumber(const AffineNumber& v, Vector s, Vector r, Vector n)
        : value(v), slope(s), spread(r), rounding(n) {}
    HWY_INLINE SlopeNumber(AffineUniform c)
        : value(c), slope(zeroVector()), spread(zeroVector()), rounding(zeroVector()) {}
};

/// The operations with a slope are those of SlopeEvaluator::covers(); of others it is not known.
class SlopeAlgebra {
  public:
    using Number = SlopeNumber;
    using Uniform = AffineUniform;
    static constexpr std::size_t components = 6;
    static constexpr bool fuses = false;

    void begin(const TapeWorkspace& workspace, std::size_t number) { forms_.begin(workspace, number); }

    static HWY_INLINE Number load(const double* lanes) {
        const auto at = [=](std::size_t c) HWY_ATTR { return hn::LoadU(Doubles(), lanes + c * batchLanes); };
        return {{at(0), at(1), at(2)}, at(3), at(4), at(5)};
    }
    static HWY_INLINE void store(const Number& p, double* lanes) {
        AffineAlgebra::store(p.value, lanes);
        const Vector rest[] = {p.slope, p.spread, p.rounding};
        for (std::size_t c = 0; c < 3; ++c) hn::Store(rest[c], Doubles(), lanes + (3 + c) * batchLanes);
    }
    static HWY_INLINE Uniform uniform(double value) { return {constantVector(value)}; }
    static HWY_INLINE Number widen(Uniform c) { return c; }
    static HWY_INLINE bool isExactLane(const double* lane) { return AffineAlgebra::isExactLane(lane); }
    static HWY_INLINE Number choose(Mask first, const Number& p, const Number& q) {
        return withoutSlope(chooseNumber(first, p.value, q.value));
    }
    static HWY_INLINE Number increment(const Number& p) {
        return withoutSlope(AffineAlgebra::increment(p.value));
    }

    HWY_INLINE Number negate(const Number& p) const {
        return {negated(p.value), hn::Neg(p.slope), p.spread, p.rounding};
    }
    HWY_INLINE Number add(const Number& p, const Number& q) const {
        const Vector slope = hn::Add(p.slope, q.slope);
        return sum(sumOf(p.value, q.value), slope, hn::Add(p.spread, q.spread),
                   hn::Add(p.rounding, q.rounding));
    }
    HWY_INLINE Number add(const Number& p, Uniform c) const {
        return sum(sumOf(p.value, c), p.slope, p.spread, p.rounding);
    }
    HWY_INLINE Number add(Uniform c, const Number& p) const { return add(p, c); }
    HWY_INLINE Number subtract(const Number& p, const Number& q) const { return add(p, negate(q)); }
    HWY_INLINE Number subtract(const Number& p, Uniform c) const { return add(p, Uniform{hn::Neg(c.a)}); }
    HWY_INLINE Number subtract(Uniform c, const Number& p) const { return add(negate(p), c); }

    HWY_INLINE Number multiply(const Number& p, const Number& q) const {
        const Vector sizeP = size(p), sizeQ = size(q);
        const Vector rounding =
            hn::MulAdd(hn::Add(sizeP, p.rounding), q.rounding, hn::Mul(sizeQ, p.rounding));
        const Vector greatest = hn::Mul(hn::Add(sizeP, p.rounding), hn::Add(sizeQ, q.rounding));
        return {productOf(p.value, q.value), hn::MulAdd(p.value.a, q.slope, hn::Mul(q.value.a, p.slope)),
                rounded(hn::Add(productSpread(p, q), productSpread(q, p)),
                        hn::MulAdd(sizeP, hn::Abs(q.slope), hn::Mul(sizeQ, hn::Abs(p.slope)))),
                rounded(rounding, greatest)};
    }
    HWY_INLINE Number multiply(const Number& p, Uniform c) const {
        return scaled(forms_.multiply(p.value, c), p, c.a);
    }
    HWY_INLINE Number multiply(Uniform c, const Number& p) const { return multiply(p, c); }
    HWY_INLINE Number square(const Number& p) const {
        const Vector greatest = hn::Add(size(p), p.rounding);
        const Vector slope = hn::Mul(p.value.a, p.slope), spread = productSpread(p, p);
        return {squareOf(p.value), hn::Add(slope, slope),
                rounded(hn::Add(spread, spread), hn::Mul(size(p), hn::Abs(p.slope))),
                rounded(hn::Mul(hn::Add(greatest, size(p)), p.rounding), hn::Mul(greatest, greatest))};
    }

    HWY_INLINE Number divide(const Number& p, const Number& q) const {
        // (p / q)' = (p' - p / q q') / q.
        const AffineNumber value = forms_.divide(p.value, q.value);
        const VectorRange range = rangeOf(q.value);
        const Vector one = constantVector(1);
        const Vector first = hn::Div(one, range.high), last = hn::Div(one, range.low);
        const Number quotient{value, q.slope, q.spread, zeroVector()};
        const Vector slope = hn::Sub(p.slope, hn::Mul(value.a, q.slope));
        const Vector spread = rounded(hn::Add(p.spread, productSpread(quotient, q)),
                                      hn::MulAdd(size(quotient), hn::Abs(q.slope), hn::Abs(p.slope)));
        const Number result = steepened(value, slope, spread, first, last);
        const Vector nearest = hn::Min(hn::Abs(range.low), hn::Abs(range.high));
        const Vector least = hn::Sub(nearest, q.rounding);
        const Vector change = hn::Div(hn::MulAdd(size(quotient), q.rounding, p.rounding), least);
        const Vector rounding = rounded(change, hn::Add(size(quotient), change));
        const Mask safe = hn::And(hn::Gt(hn::Mul(range.low, range.high), zeroVector()),
                                  hn::Gt(least, hn::Mul(nearest, constantVector(0.5))));
        return onlyWhere(safe, {value, result.slope, result.spread, rounding});
    }
    HWY_INLINE Number divide(const Number& p, Uniform c) const {
        // The quotient by the inverse differs by two more roundings.
        const Number result = scaled(forms_.divide(p.value, c), p, hn::Div(constantVector(1), c.a));
        return {result.value, result.slope, result.spread,
                rounded(result.rounding, hn::Add(size(result), result.rounding))};
    }
    HWY_INLINE Number divide(Uniform c, const Number& p) const { return divide(widen(c), p); }

    HWY_INLINE Number squareRoot(const Number& p) const {
        const AffineNumber value = forms_.squareRoot(p.value);
        const VectorRange range = rangeOf(p.value);
        const Vector steepest = hn::Div(constantVector(0.5), hn::Sqrt(range.low));
        const Vector flattest = hn::Div(constantVector(0.5), hn::Sqrt(range.high));
        const Number result = steepened(value, p.slope, p.spread, flattest, steepest);
        // Where the rounding is small, the root changes by less than 0.6 times of it to the root's inverse.
        const Vector change = hn::Mul(hn::Mul(p.rounding, steepest), constantVector(1.2));
        const Mask safe =
            hn::Gt(range.low, hn::Add(hn::Mul(p.rounding, constantVector(4)), constantVector(underflow)));
        return onlyWhere(
            safe, {value, result.slope, result.spread, rounded(change, hn::Add(size(result), change))});
    }
    HWY_INLINE Number exponential(const Number& p) const {
        const AffineNumber value = forms_.exponential(p.value);
        const VectorRange range = rangeOf(value);
        const Number result = steepened(value, p.slope, p.spread, range.low, range.high);
        const Vector change = hn::Mul(hn::Mul(size(result), p.rounding), constantVector(1.01));
        const Vector error = hn::MulAdd(size(result), constantVector(functionError), change);
        return onlyWhere(hn::Lt(p.rounding, constantVector(0.01)),
                         {value, result.slope, result.spread, rounded(error, size(result))});
    }
    HWY_INLINE Number sine(const Number& p) const {
        Number sines, cosines;
        sineAndCosine(p, sines, cosines);
        return sines;
    }
    HWY_INLINE Number cosine(const Number& p) const {
        Number sines, cosines;
        sineAndCosine(p, sines, cosines);
        return cosines;
    }
    HWY_INLINE void sineAndCosine(const Number& p, Number& sines, Number& cosines) const {
        AffineNumber s, c;
        forms_.sineAndCosine(p.value, s, c);
        const Vector rounding = hn::Add(p.rounding, constantVector(2 * angleError));
        const Mask safe = hn::Lt(hn::Add(size(p), p.rounding), constantVector(largestAngle));
        const VectorRange rangeS = rangeOf(s), rangeC = rangeOf(c);
        sines = steepened(s, p.slope, p.spread, rangeC.low, rangeC.high);
        cosines = steepened(c, p.slope, p.spread, hn::Neg(rangeS.high), hn::Neg(rangeS.low));
        sines.rounding = cosines.rounding = rounded(rounding, zeroVector());
        sines = onlyWhere(safe, sines);
        cosines = onlyWhere(safe, cosines);
    }

    HWY_INLINE Number cycle(const Number& p) const {
        Number sines, cosines;
        const Number angle = multiply(p, Uniform{constantVector(turn)});
        sineAndCosine(angle, sines, cosines);
        // The slope is off by the same angle as the value.
        const Vector error = hn::Mul(hn::Add(size(p), constantVector(2)), constantVector(4 * turnError));
        const Vector steepest = hn::Add(hn::Abs(angle.slope), angle.spread);
        return {forms_.cycle(p.value), sines.slope,
                rounded(hn::MulAdd(steepest, error, sines.spread), zeroVector()),
                rounded(hn::Add(sines.rounding, constantVector(8 * turnError)), zeroVector())};
    }
    HWY_INLINE Number absolute(const Number& p) const {
        const VectorRange range = rangeOf(p.value);
        const Mask positive = hn::Ge(range.low, zeroVector()), negative = hn::Le(range.high, zeroVector());
        const Vector slope =
            hn::IfThenElse(positive, p.slope, hn::IfThenElseZero(negative, hn::Neg(p.slope)));
        const Vector steepest = rounded(hn::Add(hn::Abs(p.slope), p.spread), zeroVector());
        const Vector spread = hn::IfThenElse(hn::Or(positive, negative), p.spread, steepest);
        return {forms_.absolute(p.value), slope, spread, p.rounding};
    }
    template <class P, class Q>
    HWY_INLINE Number minimum(const P& p, const Q& q) const {
        return either(p, q, forms_.minimum(form(p), form(q)));
    }
    template <class P, class Q>
    HWY_INLINE Number maximum(const P& p, const Q& q) const {
        return either(p, q, forms_.maximum(form(p), form(q)));
    }

    // clang-format off
#define ISOSCOPE_UNARY(operation) \
    HWY_INLINE Number operation(const Number& p) const { return withoutSlope(forms_.operation(p.value)); }
#define ISOSCOPE_BINARY(operation) \
    template <class P, class Q> HWY_INLINE Number operation(const P& p, const Q& q) const { return withoutSlope(forms_.operation(form(p), form(q))); }
    ISOSCOPE_OTHER_OPERATIONS(ISOSCOPE_UNARY, ISOSCOPE_BINARY)
#undef ISOSCOPE_BINARY
#undef ISOSCOPE_UNARY
    // clang-format on
    HWY_INLINE Number select3(const Number& p, const Number& q, const Number& r) const {
        return withoutSlope(forms_.select3(p.value, q.value, r.value));
    }
    HWY_INLINE Number select4(const Number& p, const Number& q, const Number& r, const Number& s) const {
        return withoutSlope(forms_.select4(p.value, q.value, r.value, s.value));
    }
    void scalarOperation(const Instruction& instruction, const CrackleSettings* crackle,
                         const std::array<const double*, 4>& operands, double* target,
                         std::size_t lanes) const {
        forms_.scalarOperation(instruction, crackle, operands, target, lanes);
        for (std::size_t i = 0; i < lanes; i += vectorLanes)
            store(withoutSlope(AffineAlgebra::load(target + i)), target + i);
    }

  private:
    static HWY_INLINE AffineNumber form(const Number& p) { return p.value; }
    static HWY_INLINE Uniform form(Uniform c) { return c; }

    static HWY_INLINE Number withoutSlope(const AffineNumber& value) {
        return {value, zeroVector(), constantVector(unlimited), constantVector(unlimited)};
    }
    static HWY_INLINE Number onlyWhere(Mask known, const Number& p) {
        return {p.value, p.slope, hn::IfThenElse(known, p.spread, constantVector(unlimited)),
                hn::IfThenElse(known, p.rounding, constantVector(unlimited))};
    }

    /// No value is further from 0.
    static HWY_INLINE Vector size(const Number& p) {
        return hn::MulAdd(hn::Abs(p.value.a), constantVector(inflation), radiusOf(p.value));
    }
    /// `error`, itself rounded, and what a few roundings of numbers up to `greatest` add to it.
    static HWY_INLINE Vector rounded(Vector error, Vector greatest) {
        const Vector extra =
            hn::MulAdd(greatest, constantVector(8 * roundingUnit), constantVector(underflow));
        return hn::MulAdd(error, constantVector(inflation), extra);
    }

    static HWY_INLINE Number sum(const AffineNumber& value, Vector slope, Vector spread, Vector rounding) {
        const Number result{value, slope, rounded(spread, hn::Abs(slope)), rounding};
        return {value, slope, result.spread, rounded(rounding, hn::Add(size(result), rounding))};
    }
    static HWY_INLINE Number scaled(const AffineNumber& value, const Number& p, Vector factor) {
        const Vector slope = hn::Mul(p.slope, factor), rounding = hn::Mul(p.rounding, hn::Abs(factor));
        const Number result{value, slope, rounded(hn::Mul(p.spread, hn::Abs(factor)), hn::Abs(slope)),
                            rounding};
        return {value, slope, result.spread, rounded(rounding, hn::Add(size(result), rounding))};
    }
    /// How far p q' is from p.value.a q.slope.
    static HWY_INLINE Vector productSpread(const Number& p, const Number& q) {
        const Vector steepest = hn::Add(hn::Abs(q.slope), q.spread);
        return hn::MulAdd(hn::Abs(p.value.a), q.spread, hn::Mul(radiusOf(p.value), steepest));
    }
    /// slope +- spread times a factor between low and high, which are rounded.
    static HWY_INLINE Number steepened(const AffineNumber& value, Vector slope, Vector spread, Vector low,
                                       Vector high) {
        const Vector factor = half(hn::Add(low, high)), apart = hn::Abs(half(hn::Sub(high, low)));
        const Vector greatest = hn::Add(hn::Abs(low), hn::Abs(high));
        const Vector reach = hn::Add(hn::Abs(slope), spread);
        return {value, hn::Mul(slope, factor),
                rounded(hn::MulAdd(apart, reach, hn::Mul(hn::Abs(factor), spread)), hn::Mul(greatest, reach)),
                zeroVector()};
    }
    static HWY_INLINE Number either(const Number& p, const Number& q, const AffineNumber& value) {
        const Vector low = hn::Min(hn::Sub(p.slope, p.spread), hn::Sub(q.slope, q.spread));
        const Vector high = hn::Max(hn::Add(p.slope, p.spread), hn::Add(q.slope, q.spread));
        const Vector spread = rounded(half(hn::Sub(high, low)), hn::Add(hn::Abs(low), hn::Abs(high)));
        // hn::Min and hn::Max may drop what is not a number.
        const Vector limit = constantVector(unlimited);
        const Mask known = hn::And(hn::And(isKnown(p.value), isKnown(q.value)),
                                   hn::And(hn::And(hn::Lt(p.spread, limit), hn::Lt(q.spread, limit)),
                                           hn::And(hn::Lt(p.rounding, limit), hn::Lt(q.rounding, limit))));
        return onlyWhere(known, {value, half(hn::Add(low, high)), spread, hn::Max(p.rounding, q.rounding)});
    }

    AffineAlgebra forms_;
};

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
