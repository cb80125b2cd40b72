// SPDX-License-Identifier: GPL-3.0-or-later
// Included once per instruction set. The operations of a function graph on affine forms: each result holds
// every value of the operation along the piece of the ray.
#if defined(ISOSCOPE_EVALUATE_AFFINE_ALGEBRA_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOSCOPE_EVALUATE_AFFINE_ALGEBRA_INL
#undef ISOSCOPE_EVALUATE_AFFINE_ALGEBRA_INL
#else
#define ISOSCOPE_EVALUATE_AFFINE_ALGEBRA_INL
#endif

#include <hwy/highway.h>

#include <array>
#include <cmath>

#include "core/evaluate/algebra/affine_crackle.h"
#include "core/evaluate/algebra/affine_elementary-inl.h"
#include "core/evaluate/algebra/affine_form.h"
#include "core/evaluate/algebra/affine_noise-inl.h"
#include "core/evaluate/algebra/euclidean_crackle.h"
#include "core/evaluate/tape/tape_workspace.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

class AffineAlgebra {
  public:
    using Number = AffineNumber;
    using Uniform = AffineUniform;
    static constexpr std::size_t components = 3;
    /// Whether pairs of sums and products are run as one.
    static constexpr bool fuses = true;

    /// Before instruction `number` of the workspace's tape.
    void begin(const TapeWorkspace& workspace, std::size_t number) {
        domains_ = workspace.operandDomains(number);
    }

    static HWY_INLINE Number load(const double* lanes) {
        const Doubles d;
        return {hn::LoadU(d, lanes), hn::LoadU(d, lanes + batchLanes), hn::LoadU(d, lanes + 2 * batchLanes)};
    }
    static HWY_INLINE void store(const Number& p, double* lanes) {
        const Doubles d;
        hn::Store(p.a, d, lanes);
        hn::Store(p.b, d, lanes + batchLanes);
        hn::Store(p.e, d, lanes + 2 * batchLanes);
    }
    static HWY_INLINE Uniform uniform(double value) { return {constantVector(value)}; }
    static HWY_INLINE Number widen(Uniform c) { return c; }
    static HWY_INLINE Number choose(Mask first, const Number& p, const Number& q) {
        return chooseNumber(first, p, q);
    }
    static HWY_INLINE bool isExactLane(const double* lane) {
        return lane[batchLanes] == 0 && lane[2 * batchLanes] == 0;
    }
    /// The loop variable plus 1, exact as long as it is a whole number.
    static HWY_INLINE Number increment(const Number& p) {
        const Vector one = constantVector(1);
        const Vector a = hn::Add(p.a, one);
        const Mask exact = hn::Eq(hn::Sub(a, one), p.a);
        const Vector e = hn::Add(p.e, hn::Mul(hn::Abs(a), constantVector(roundingUnit)));
        return {a, p.b, hn::IfThenElse(exact, p.e, e)};
    }

    HWY_INLINE Number negate(const Number& p) const { return negated(p); }
    HWY_INLINE Number absolute(const Number& p) const { return absoluteOf(p); }
    HWY_INLINE Number square(const Number& p) const { return squareOf(p); }
    HWY_INLINE Number squareRoot(const Number& p) const { return squareRootOf(p, domain(0)); }
    HWY_INLINE Number exponential(const Number& p) const { return exponentialOf(p); }
    HWY_INLINE Number naturalLogarithm(const Number& p) const { return logarithmOf(p, domain(0)); }
    HWY_INLINE Number decimalLogarithm(const Number& p) const {
        // log10(e) is itself rounded.
        const Number scaled = scaledBy(logarithmOf(p, domain(0)), constantVector(0.43429448190325182765));
        const Vector error =
            hn::Mul(hn::Add(hn::Abs(scaled.a), hn::Abs(scaled.b)), constantVector(2 * roundingUnit));
        return {scaled.a, scaled.b, hn::MulAdd(scaled.e, constantVector(inflation), error)};
    }
    HWY_INLINE Number sine(const Number& p) const { return sineOf(p); }
    HWY_INLINE Number cosine(const Number& p) const { return cosineOf(p); }
    HWY_INLINE void sineAndCosine(const Number& p, Number& sines, Number& cosines) const {
        waves(p, sines, cosines);
    }
    HWY_INLINE Number tangent(const Number& p) const { return tangentOf(p); }
    HWY_INLINE Number arcSine(const Number& p) const { return arcSineOf(p, domain(0)); }
    HWY_INLINE Number arcCosine(const Number& p) const { return arcCosineOf(p, domain(0)); }
    HWY_INLINE Number arcTangent(const Number& p) const { return arcTangentOf(p); }
    HWY_INLINE Number hyperbolicSine(const Number& p) const { return hyperbolicSineOf(p); }
    HWY_INLINE Number hyperbolicCosine(const Number& p) const { return hyperbolicCosineOf(p); }
    HWY_INLINE Number hyperbolicTangent(const Number& p) const { return hyperbolicTangentOf(p); }
    HWY_INLINE Number areaSine(const Number& p) const { return areaSineOf(p); }
    HWY_INLINE Number areaCosine(const Number& p) const { return areaCosineOf(p, domain(0)); }
    HWY_INLINE Number areaTangent(const Number& p) const { return areaTangentOf(p, domain(0)); }

    HWY_INLINE Number floor(const Number& p) const {
        // The domain keeps a root or a length of 0 from the step below 0.
        return stepped(
            p, clippedRange(p, domain(0)), [](Vector v) HWY_ATTR { return hn::Floor(v); }, -1, 0);
    }
    HWY_INLINE Number fraction(const Number& p) const {
        const VectorRange range = rangeOf(p);
        const Vector first = hn::Floor(range.low);
        const Number between = differenceOf(p, exactNumber(first));
        return keepUnknown(p, chooseNumber(hn::Eq(first, hn::Floor(range.high)), between, anywhereInUnit()));
    }
    HWY_INLINE Number triangleWave(const Number& p) const { return triangleWaveOf(p); }
    HWY_INLINE Number cycle(const Number& p) const { return cycleOf(p); }
    HWY_INLINE Number ceiling(const Number& p) const {
        return stepped(
            p, clippedRange(p, domain(0)), [](Vector v) HWY_ATTR { return hn::Ceil(v); }, 0, 1);
    }
    HWY_INLINE Number truncate(const Number& p) const {
        const VectorRange range = rangeOf(p);
        const Vector smallest = constantVector(-2147483648.0), largest = constantVector(2147483648.0);
        const Mask fits =
            hn::And(hn::Gt(range.low, constantVector(-2147483649.0)), hn::Lt(range.high, largest));
        const Mask beyond =
            hn::Or(hn::Le(range.high, constantVector(-2147483649.0)), hn::Ge(range.low, largest));
        // Undefined numbers count as too large.
        const Mask never = hn::Or(isUndefined(p), hn::And(isKnown(p), beyond));
        const Number inside = stepped(
            p, range, [](Vector v) HWY_ATTR { return hn::Trunc(v); }, -1, 1);
        const Number known =
            chooseNumber(hn::And(isKnown(p), fits), inside, betweenNumber(smallest, largest));
        return chooseNumber(never, exactNumber(smallest), known);
    }

    HWY_INLINE Number add(const Number& p, const Number& q) const { return sumOf(p, q); }
    HWY_INLINE Number add(const Number& p, Uniform c) const { return sumOf(p, c); }
    HWY_INLINE Number add(Uniform c, const Number& p) const { return sumOf(p, c); }
    HWY_INLINE Number subtract(const Number& p, const Number& q) const { return differenceOf(p, q); }
    HWY_INLINE Number subtract(const Number& p, Uniform c) const { return sumOf(p, Uniform{hn::Neg(c.a)}); }
    HWY_INLINE Number subtract(Uniform c, const Number& p) const { return sumOf(negated(p), c); }
    HWY_INLINE Number multiply(const Number& p, const Number& q) const { return productOf(p, q); }
    HWY_INLINE Number multiply(const Number& p, Uniform c) const { return scaledBy(p, c.a); }
    HWY_INLINE Number multiply(Uniform c, const Number& p) const { return scaledBy(p, c.a); }
    HWY_INLINE Number divide(const Number& p, const Number& q) const {
        return productOf(p, reciprocalOf(q, domain(1)));
    }
    HWY_INLINE Number divide(const Number& p, Uniform c) const {
        // One division for all lanes. The factor's rounding is added; that of a factor with fewer digits,
        // below the normal numbers, would be larger.
        const Vector factor = hn::Div(constantVector(1), c.a);
        const Number scaled = scaledBy(p, factor);
        const Vector rounding =
            hn::Mul(hn::Add(hn::Abs(scaled.a), hn::Abs(scaled.b)), constantVector(roundingUnit));
        const Vector e = hn::MulAdd(scaled.e, constantVector(inflation), rounding);
        const Mask precise = hn::Ge(hn::Abs(factor), constantVector(underflow));
        return keepUnknown(p, {scaled.a, scaled.b, hn::IfThenElse(precise, e, constantVector(unlimited))});
    }
    HWY_INLINE Number divide(Uniform c, const Number& p) const {
        return scaledBy(reciprocalOf(p, domain(1)), c.a);
    }

    HWY_INLINE Number power(const Number& p, const Number& q) const {
        // exp(q ln p); whole exponents have negative bases too, so nothing else is known.
        const Number value = exponentialOf(productOf(q, logarithmOf(p, domain(0))));
        return chooseNumber(isKnown(value), value, unknownNumber());
    }
    HWY_INLINE Number power(Uniform c, const Number& p) const {
        const Vector value = HWY_NAMESPACE::naturalLogarithm(c.a);
        const Number logarithm{value, zeroVector(), relativeError(value)};
        const Number result = exponentialOf(productOf(p, logarithm));
        const Mask usable = hn::And(hn::Gt(c.a, zeroVector()), hn::Lt(c.a, constantVector(unlimited)));
        return chooseNumber(hn::And(usable, isKnown(result)), result, unknownNumber());
    }
    HWY_INLINE Number power(const Number& p, Uniform c) const {
        const double exponent = hn::GetLane(c.a);
        if (exponent == 0) return exactNumber(constantVector(1));
        // 1 to any power is 1, and hn::Min and hn::Max below would drop a NaN.
        if (std::isnan(exponent)) return unknownNumber();
        if (std::floor(exponent) == exponent && std::abs(exponent) <= 64) {
            const Number whole = signedPower(p, static_cast<int>(std::abs(exponent)));
            return exponent < 0 ? reciprocalOf(whole, {constantVector(-unlimited), constantVector(unlimited)})
                                : whole;
        }
        return realPower(p, c.a, exponent);
    }

    HWY_INLINE Number arcTangent2(const Number& p, const Number& q) const { return arcTangent2Of(p, q); }
    HWY_INLINE Number remainder(const Number& p, const Number& q) const {
        return remainderOf(p, q, quotientOf(p, q));
    }
    HWY_INLINE Number integerDivide(const Number& p, const Number& q) const {
        return truncate(quotientOf(p, q));
    }

    HWY_INLINE Number minimum(const Number& p, const Number& q) const {
        const Number result = lesser(p, q);
        const Mask known = hn::And(isKnown(p), isKnown(q));
        if (HWY_LIKELY(hn::AllTrue(Doubles(), known))) return result;
        // a <= b ? a : b takes b when a side is undefined.
        const Number rest = chooseNumber(hn::Or(isUndefined(p), isUndefined(q)), q, unknownNumber());
        return chooseNumber(known, result, rest);
    }
    HWY_INLINE Number minimum(const Number& p, Uniform c) const {
        return isBelowAll(p, c) ? p : minimumOfBoth(p, c);
    }
    HWY_INLINE Number minimum(Uniform c, const Number& p) const {
        return isBelowAll(p, c) ? p : minimumOfBoth(c, p);
    }
    HWY_INLINE Number maximum(const Number& p, const Number& q) const {
        const Number result = negated(lesser(negated(p), negated(q)));
        const Mask known = hn::And(isKnown(p), isKnown(q));
        if (HWY_LIKELY(hn::AllTrue(Doubles(), known))) return result;
        // a < b ? b : a takes a when a side is undefined.
        const Number rest = chooseNumber(hn::Or(isUndefined(p), isUndefined(q)), p, unknownNumber());
        return chooseNumber(known, result, rest);
    }
    HWY_INLINE Number maximum(const Number& p, Uniform c) const {
        return isAboveAll(p, c) ? p : maximumOfBoth(p, c);
    }
    HWY_INLINE Number maximum(Uniform c, const Number& p) const {
        return isAboveAll(p, c) ? p : maximumOfBoth(c, p);
    }

    HWY_INLINE Number less(const Number& p, const Number& q) const { return isBelow(p, q, false); }
    HWY_INLINE Number lessEqual(const Number& p, const Number& q) const { return isBelow(p, q, true); }
    HWY_INLINE Number greater(const Number& p, const Number& q) const { return opposite(lessEqual(p, q)); }
    HWY_INLINE Number greaterEqual(const Number& p, const Number& q) const { return opposite(less(p, q)); }
    HWY_INLINE Number equal(const Number& p, const Number& q) const {
        const Number difference = differenceOf(p, q);
        const VectorRange range = rangeOf(difference);
        const Mask known = hn::And(isKnown(p), isKnown(q));
        const Mask apart =
            hn::And(known, hn::Or(hn::Gt(range.low, zeroVector()), hn::Lt(range.high, zeroVector())));
        const Mask undefined = hn::Or(isUndefined(p), isUndefined(q));
        const Mask same = hn::And(hn::And(isExact(p), isExact(q)), hn::Eq(p.a, q.a));
        return decided(same, hn::Or(apart, undefined));
    }
    HWY_INLINE Number notEqual(const Number& p, const Number& q) const { return opposite(equal(p, q)); }
    HWY_INLINE Number logicalAnd(const Number& p, const Number& q) const {
        return decided(hn::And(isTrue(p), isTrue(q)), hn::Or(isFalse(p), isFalse(q)));
    }
    HWY_INLINE Number logicalOr(const Number& p, const Number& q) const {
        return decided(hn::Or(isTrue(p), isTrue(q)), hn::And(isFalse(p), isFalse(q)));
    }

    HWY_INLINE Number select3(const Number& p, const Number& negative, const Number& otherwise) const {
        const VectorRange range = rangeOf(p);
        const Mask below = hn::And(isKnown(p), hn::Lt(range.high, zeroVector()));
        const Mask above = hn::Or(isUndefined(p), hn::And(isKnown(p), hn::Ge(range.low, zeroVector())));
        const Number either = hullOf(negative, otherwise);
        return chooseNumber(below, negative, chooseNumber(above, otherwise, either));
    }
    HWY_INLINE Number select4(const Number& p, const Number& negative, const Number& zero,
                              const Number& positive) const {
        const VectorRange range = rangeOf(p);
        const Mask below = hn::And(isKnown(p), hn::Lt(range.high, zeroVector()));
        const Mask above = hn::Or(isUndefined(p), hn::And(isKnown(p), hn::Gt(range.low, zeroVector())));
        const Mask at = hn::And(isExact(p), hn::Eq(p.a, zeroVector()));
        const Number any = hullOf(negative, hullOf(zero, positive));
        return chooseNumber(below, negative, chooseNumber(above, positive, chooseNumber(at, zero, any)));
    }

    /// noise() of a generator 0 to 3; of 0 to 2 also without lanes for a y of 0.
    static void noise(int generator, const std::array<const double*, 3>& place, std::size_t lanes,
                      double* target) {
        affineNoise(generator, {place[0], place[1], place[2]}, lanes, target);
    }
    void scalarOperation(const Instruction& instruction, const CrackleSettings* crackle,
                         const std::array<const double*, 4>& operands, double* target,
                         std::size_t lanes) const {
        const double *a = operands[0], *b = operands[1], *c = operands[2];
        if (instruction.operation == Operation::noise) {
            if (allExact(a, lanes))
                return evaluateNoise<AffineAlgebra>(a, {operands[1], operands[2], operands[3]}, lanes,
                                                    target);
            for (std::size_t i = 0; i < lanes; i += vectorLanes) store(anywhereInUnit(), target + i);
        } else if (isVectorNoise(instruction.operation)) {
            affineVectorNoise(noiseComponent(instruction.operation), {a, b, c}, lanes, target);
        } else {
            crackleLanes(*crackle, operands, target, lanes);
        }
    }

  protected:
    HWY_INLINE VectorRange domain(std::size_t operand) const {
        return {constantVector(domains_[2 * operand]), constantVector(domains_[2 * operand + 1])};
    }

    /// divide(), by one number for a lane where they are known, which takes no reciprocal of a form.
    HWY_INLINE Number quotientOf(const Number& p, const Number& q) const {
        const Mask divisible = hn::And(isExact(q), hn::Ne(q.a, zeroVector()));
        if (HWY_LIKELY(hn::AllTrue(Doubles(), divisible))) return divide(p, Uniform{q.a});
        return divide(p, q);
    }
    /// remainder(), given the quotient of both.
    static HWY_INLINE Number remainderOf(const Number& p, const Number& q, const Number& quotient) {
        const VectorRange range = rangeOf(quotient);
        const Vector first = hn::Trunc(range.low), last = hn::Trunc(range.high);
        const Mask same = hn::And(isKnown(quotient), hn::Eq(first, last));
        const Number between = differenceOf(p, productOf(q, exactNumber(first)));
        if (HWY_LIKELY(hn::AllTrue(Doubles(), same))) return between;
        // |result| < |q| and |result| <= |p|, with the sign of p; a divisor that may be 0 says nothing.
        const VectorRange dividend = rangeOf(p), divisor = rangeOf(q);
        const Mask safe =
            hn::And(hn::And(isKnown(p), isKnown(q)),
                    hn::Or(hn::Gt(divisor.low, zeroVector()), hn::Lt(divisor.high, zeroVector())));
        const Vector bound = hn::Max(hn::Abs(divisor.low), hn::Abs(divisor.high));
        const Vector low = hn::Max(hn::Neg(bound), hn::Min(dividend.low, zeroVector()));
        const Vector high = hn::Min(bound, hn::Max(dividend.high, zeroVector()));
        const Number loose = chooseNumber(safe, betweenNumber(low, high), keepUnknown(p, q, unknownNumber()));
        return chooseNumber(same, between, loose);
    }

    /// Every value of either: the least form with the mean of their slopes.
    static HWY_INLINE Number hullOf(const Number& p, const Number& q) {
        const Vector b = half(hn::Add(p.b, q.b));
        const Vector apart = reachFrom(b, hn::Min(p.b, q.b), hn::Max(p.b, q.b));
        const Vector reachOfP = hn::Add(p.e, apart), reachOfQ = hn::Add(q.e, apart);
        const Vector high = hn::Max(hn::Add(p.a, reachOfP), hn::Add(q.a, reachOfQ));
        const Vector low = hn::Min(hn::Sub(p.a, reachOfP), hn::Sub(q.a, reachOfQ));
        const Vector size =
            hn::Add(hn::Add(hn::Abs(high), hn::Abs(low)), hn::Add(hn::Abs(p.b), hn::Abs(q.b)));
        const Vector rounding = hn::Mul(size, constantVector(4 * roundingUnit));
        const Vector center = half(hn::Add(high, low));
        const Number both{center, b,
                          hn::MulAdd(reachFrom(center, low, high), constantVector(inflation), rounding)};
        const Mask known = hn::And(isKnown(p), isKnown(q));
        const Mask nowhere = hn::And(isUndefined(p), isUndefined(q));
        return chooseNumber(known, both, chooseNumber(nowhere, undefinedNumber(), unknownNumber()));
    }

  private:
    static bool allExact(const double* form, std::size_t lanes) {
        bool exact = true;
        for (std::size_t i = 0; i < lanes; i += vectorLanes)
            exact = exact && hn::AllTrue(Doubles(), isExact(load(form + i)));
        return exact;
    }

    static void crackleLanes(const CrackleSettings& crackle, const std::array<const double*, 4>& operands,
                             double* target, std::size_t lanes) {
        const auto column = [&](std::size_t k) {
            return FormColumn{operands[k], operands[k] + batchLanes, operands[k] + 2 * batchLanes};
        };
        writeAffineCrackle({column(0), column(1), column(2)}, crackle, lanes,
                           {target, target + batchLanes, target + 2 * batchLanes});
    }

    /// A staircase: constant where both ends of the range agree, else the operand plus [low, high].
    template <class Round>
    static HWY_INLINE Number stepped(const Number& p, const VectorRange& range, Round round, double low,
                                     double high) {
        const Vector first = round(range.low), last = round(range.high);
        const Number line = lineWithRest(p, constantVector(1), constantVector(low), constantVector(high));
        return keepUnknown(p, chooseNumber(hn::Eq(first, last), exactNumber(first), line));
    }

    /// Whether bounds change nothing in any lane. What is to be done else is kept out of loops over lanes.
    static HWY_INLINE bool isBelowAll(const Number& p, Uniform c) {
        return hn::AllTrue(Doubles(), hn::And(isKnown(p), hn::Le(rangeOf(p).high, c.a)));
    }
    static HWY_INLINE bool isAboveAll(const Number& p, Uniform c) {
        return hn::AllTrue(Doubles(), hn::And(isKnown(p), hn::Ge(rangeOf(p).low, c.a)));
    }
    HWY_NOINLINE Number minimumOfBoth(Number p, Number q) const { return minimum(p, q); }
    HWY_NOINLINE Number maximumOfBoth(Number p, Number q) const { return maximum(p, q); }

    /// The smaller of two known numbers: one of them where that is certain, else a mean of both with weights
    /// that follow the chord of |p - q|, or, where that is nearer, what lies between the lesser ends of both.
    static HWY_INLINE Number lesser(const Number& p, const Number& q) {
        const Number difference = differenceOf(p, q);
        const VectorRange range = rangeOf(difference);
        const Mask first = hn::Le(range.high, zeroVector()), second = hn::Ge(range.low, zeroVector());
        const Number sure = chooseNumber(first, p, q);
        if (hn::AllTrue(Doubles(), hn::Or(first, second))) return sure;
        const Vector width = hn::Div(constantVector(1), hn::Sub(range.high, range.low));
        const Vector chord = hn::Mul(hn::Add(range.high, range.low), width);
        const Vector rise = hn::Mul(hn::Mul(hn::Neg(range.low), width), range.high);
        const Vector one = constantVector(1);
        const Vector alpha = half(hn::Sub(one, chord)), beta = half(hn::Add(one, chord));
        const Vector a = hn::Sub(hn::MulAdd(alpha, p.a, hn::Mul(beta, q.a)), half(rise));
        const Vector b = hn::MulAdd(alpha, p.b, hn::Mul(beta, q.b));
        const Vector e = hn::Add(hn::MulAdd(alpha, p.e, hn::Mul(beta, q.e)), half(rise));
        const Vector magnitude =
            hn::Add(hn::Add(hn::Abs(p.a), hn::Abs(q.a)), hn::Add(hn::Abs(p.b), hn::Abs(q.b)));
        const Vector rounding = hn::MulAdd(hn::Add(magnitude, hn::Add(p.e, q.e)),
                                           constantVector(8 * roundingUnit), constantVector(underflow));
        const Number mixed{a, b, hn::MulAdd(e, constantVector(inflation), rounding)};
        const VectorRange ofP = rangeOf(p), ofQ = rangeOf(q);
        const Number flat = betweenNumber(hn::Min(ofP.low, ofQ.low), hn::Min(ofP.high, ofQ.high));
        // Where a difference of the smallest numbers divides, the mean is no number.
        const Mask flatter = hn::Not(hn::Le(mixed.e, flat.e));
        return chooseNumber(hn::Or(first, second), sure, chooseNumber(flatter, flat, mixed));
    }

    /// 1, 0, or either.
    static HWY_INLINE Number decided(Mask yes, Mask no) {
        const Vector halfway = constantVector(0.5);
        const Number open{halfway, zeroVector(), halfway};
        return chooseNumber(yes, exactNumber(constantVector(1)),
                            chooseNumber(no, exactNumber(zeroVector()), open));
    }
    static HWY_INLINE Number opposite(const Number& p) { return {hn::Sub(constantVector(1), p.a), p.b, p.e}; }
    /// p < q, or p <= q; false when a side is undefined.
    static HWY_INLINE Number isBelow(const Number& p, const Number& q, bool orEqual) {
        const VectorRange range = rangeOf(differenceOf(p, q));
        const Mask known = hn::And(isKnown(p), isKnown(q));
        const Mask undefined = hn::Or(isUndefined(p), isUndefined(q));
        const Mask exact = hn::And(isExact(p), isExact(q));
        const Mask tie = hn::And(exact, hn::Eq(p.a, q.a));
        const Mask yes = hn::And(known, hn::Lt(range.high, zeroVector()));
        const Mask no = hn::Or(undefined, hn::And(known, hn::Gt(range.low, zeroVector())));
        return orEqual ? decided(hn::Or(yes, tie), no) : decided(yes, hn::Or(no, tie));
    }
    /// Not 0 for certain; NaN counts.
    static HWY_INLINE Mask isTrue(const Number& p) {
        const VectorRange range = rangeOf(p);
        const Mask away = hn::Or(hn::Gt(range.low, zeroVector()), hn::Lt(range.high, zeroVector()));
        return hn::Or(isUndefined(p), hn::And(isKnown(p), away));
    }
    static HWY_INLINE Mask isFalse(const Number& p) { return hn::And(isExact(p), hn::Eq(p.a, zeroVector())); }

    static HWY_INLINE Number wholePower(Number p, int exponent) {
        Number result = exactNumber(constantVector(1));
        bool first = true;
        for (; exponent > 0; exponent >>= 1) {
            if (exponent & 1) {
                result = first ? p : productOf(result, p);
                first = false;
            }
            if (exponent > 1) p = squareOf(p);
        }
        return result;
    }

    /// The plain range of the power where its line is no narrower, or reaches 0 where the power does not:
    /// roots and further powers of it would be lost.
    static HWY_INLINE Number signedPower(const Number& p, int exponent) {
        const Number line = wholePower(p, exponent);
        if (exponent < 4) return line;
        const VectorRange range = rangeOf(p);
        const Vector zero = zeroVector(), farther = hn::Max(hn::Abs(range.low), hn::Abs(range.high));
        const Vector nearer = hn::Max(zero, hn::Max(range.low, hn::Neg(range.high)));
        Vector least = constantVector(1), most = least;
        for (int i = 0; i < exponent; ++i) least = hn::Mul(least, nearer), most = hn::Mul(most, farther);
        const Vector rounding = constantVector(2 * exponent * roundingUnit);
        least = hn::Max(hn::Sub(least, hn::MulAdd(least, rounding, constantVector(underflow))), zero);
        most = hn::Add(most, hn::MulAdd(most, rounding, constantVector(underflow)));
        const bool odd = exponent % 2 != 0;
        const Mask falls = odd ? hn::Lt(range.high, zero) : noLane(),
                   rises = odd ? hn::Gt(range.low, zero) : falls;
        const Vector low = hn::IfThenElse(falls, hn::Neg(most), least);
        const Vector high = hn::IfThenElse(falls, hn::Neg(least), most);
        const Mask oneSided = odd ? hn::Or(falls, rises) : hn::Eq(zero, zero);
        const Number flat = betweenNumber(low, high);
        const Mask lost = hn::And(hn::Gt(least, zero), hn::Le(hn::Abs(line.a), radiusOf(line)));
        const Mask worse = hn::And(oneSided, hn::Or(lost, hn::Lt(flat.e, line.e)));
        return keepUnknown(p, chooseNumber(worse, flat, line));
    }

    /// A power with an exponent that is not a small whole number.
    HWY_INLINE Number realPower(const Number& p, Vector c, double exponent) const {
        const VectorRange range = clippedRange(p, domain(0));
        const Mask positive = hn::Gt(range.low, zeroVector());
        const Mask narrow =
            hn::And(hn::And(positive, hn::Ge(p.a, range.low)), hn::Le(radiusOf(p), half(p.a)));
        if (HWY_LIKELY(hn::AllTrue(Doubles(), narrow))) return powerAlong(p, c, exponent);
        const Mask touching = hn::And(hn::Ge(range.low, zeroVector()), hn::Gt(c, zeroVector()));
        const Mask usable = hn::Or(positive, touching);
        // Lanes that the other kind of number leaves alone are not worth a function.
        const Number best =
            hn::AllFalse(Doubles(), usable) ? unknownNumber() : powerBetween(p, range, usable, c);
        const bool whole = std::floor(exponent) == exponent;
        const Mask outside = hn::Lt(range.high, zeroVector());
        const Number below =
            whole ? unknownNumber() : chooseNumber(outside, undefinedNumber(), unknownNumber());
        return keepUnknown(p, chooseNumber(usable, best, below));
    }

    /// p^c, in the lanes of `usable`, where the range is not negative; anything in the others. The power is
    /// bent to one side: between its chord and its tangents at both ends, or its values there.
    HWY_INLINE Number powerBetween(const Number& p, const VectorRange& range, Mask usable, Vector c) const {
        const Vector zero = zeroVector(), one = constantVector(1);
        const Vector low = hn::IfThenElse(usable, range.low, one);
        const Vector high = hn::IfThenElse(usable, range.high, one);
        const auto raised = [&](Vector v) HWY_ATTR {
            const Mask positive = hn::Gt(v, zero);
            return hn::IfThenElseZero(positive, roughPower(hn::IfThenElse(positive, v, one), c));
        };
        const Vector first = raised(low), second = raised(high);
        // Ten times what the powers are off, for what is made of them.
        constexpr double inexact = 10 * roughPowerError;
        const Vector least = hn::Min(first, second), most = hn::Max(first, second);
        const auto error = [](Vector v) HWY_ATTR {
            return hn::MulAdd(v, constantVector(roughPowerError), constantVector(underflow));
        };
        const Number flat = betweenNumber(hn::Sub(least, error(least)), hn::Add(most, error(most)));

        const Vector width = hn::Sub(high, low);
        const Vector slope = hn::Div(hn::Sub(second, first), width);
        const Mask convex = hn::Or(hn::Gt(c, one), hn::Lt(c, zero));
        // How much steeper or flatter the power is at an end than the chord.
        const Vector steepnessAt0 = hn::IfThenElse(convex, zero, constantVector(unlimited));
        const auto bend = [&](Vector end, Vector value) HWY_ATTR {
            const Vector steepness =
                hn::IfThenElse(hn::Gt(end, zero), hn::Div(hn::Mul(c, value), end), steepnessAt0);
            const Vector size = hn::Add(hn::Abs(steepness), hn::Abs(slope));
            return hn::MulAdd(size, constantVector(inexact), hn::Abs(hn::Sub(steepness, slope)));
        };
        const Vector atLow = bend(low, first), atHigh = bend(high, second);
        const Vector gap = hn::Mul(hn::Div(atHigh, hn::Add(one, hn::Div(atHigh, atLow))), width);
        const Vector ends[] = {hn::NegMulAdd(slope, low, first), hn::NegMulAdd(slope, high, second)};
        const Vector size = hn::MulAdd(hn::Abs(slope), high, most);
        const Vector rounding = hn::MulAdd(size, constantVector(inexact), constantVector(underflow));
        const Vector below = hn::IfThenElseZero(convex, gap), above = hn::IfThenElse(convex, zero, gap);
        const Number line =
            lineWithRest(p, slope, hn::Sub(hn::Min(ends[0], ends[1]), hn::Add(below, rounding)),
                         hn::Add(hn::Max(ends[0], ends[1]), hn::Add(above, rounding)));
        return narrower(line, flat);
    }

    /// p^c for numbers of [a - r, a + r] with r <= a/2: f'' = c (c - 1) p^(c - 2), which is its value at a
    /// times the power c - 2 of 1 + s with |s| <= t = r/a. This power is at most exp(|c - 2| (t + t^2)).
    static HWY_INLINE Number powerAlong(const Number& p, Vector c, double exponent) {
        const Vector inverse = hn::Div(constantVector(1), p.a);
        const Vector t = hn::Mul(radiusOf(p), inverse), squared = hn::Mul(t, t);
        const Vector x = hn::Mul(hn::Add(t, squared), constantVector(std::abs(exponent - 2)));
        const Vector one = constantVector(1);
        const Mask moderate = hn::Le(x, one);
        // exp(x) <= 1 + x + x^2 to x = 1.
        const Vector growth = HWY_LIKELY(hn::AllTrue(Doubles(), moderate))
                                  ? hn::MulAdd(hn::Add(x, one), x, one)
                                  : HWY_NAMESPACE::exponential(x);
        const double bend = 0.5 * exponent * (exponent - 1) * (1 + 1e-12 + roughPowerError);
        const Vector bent = hn::Mul(hn::Mul(growth, constantVector(bend)), squared);
        // Beside so much an exact value would be wasted.
        const bool rough =
            hn::AllTrue(Doubles(), hn::Gt(hn::Abs(bent), constantVector(1000 * roughPowerError)));
        const Vector value = rough ? roughPower(p.a, c) : HWY_NAMESPACE::power(p.a, c);
        const Vector slope = hn::Mul(hn::Mul(c, value), inverse);
        // Of the value, and of the slope along the piece. A value that underflows may be one at an end.
        const Vector share = hn::MulAdd(t, constantVector(std::abs(exponent)), one);
        const Vector off =
            hn::MulAdd(value, constantVector(rough ? roughPowerError : 0), constantVector(underflow));
        const Vector error = hn::MulAdd(off, share, relativeError(value));
        const Vector rest = hn::Mul(hn::Add(value, constantVector(underflow)), bent), zero = zeroVector();
        return developed(p, value, error, slope, hn::Min(rest, zero), hn::Max(rest, zero));
    }

    const double* domains_ = nullptr;
};

/// The same, but products and squares of forms that are wide are within the plain ranges of these: for tapes
/// that multiplyRanges().
class AffineRangeAlgebra : public AffineAlgebra {
  public:
    using AffineAlgebra::multiply;
    HWY_INLINE Number multiply(const Number& p, const Number& q) const {
        const Number product = productOf(p, q);
        const Mask wide = hn::Or(isWide(p), isWide(q));
        if (HWY_LIKELY(hn::AllFalse(Doubles(), wide))) return product;
        const VectorRange x = rangeOf(p), y = rangeOf(q);
        const Vector ll = hn::Mul(x.low, y.low), lh = hn::Mul(x.low, y.high);
        const Vector hl = hn::Mul(x.high, y.low), hh = hn::Mul(x.high, y.high);
        return within(wide, product, hn::Min(hn::Min(ll, lh), hn::Min(hl, hh)),
                      hn::Max(hn::Max(ll, lh), hn::Max(hl, hh)));
    }
    HWY_INLINE Number square(const Number& p) const {
        const Number square = squareOf(p);
        const Mask wide = isWide(p);
        if (HWY_LIKELY(hn::AllFalse(Doubles(), wide))) return square;
        const Vector radius = radiusOf(p), middle = hn::Abs(p.a);
        const Vector least = hn::Max(hn::Sub(middle, radius), zeroVector()), most = hn::Add(middle, radius);
        return within(wide, square, hn::Mul(least, least), hn::Mul(most, most));
    }

  private:
    /// Lanes whose error is so much of the value that the range of a product may be less than the error of
    /// its form.
    static HWY_INLINE Mask isWide(const Number& p) { return hn::Gt(p.e, half(hn::Abs(p.a))); }

    /// A product, or in known lanes of `wide` [low, high] where its error alone leaves open more.
    static HWY_INLINE Number within(Mask wide, const Number& product, Vector low, Vector high) {
        const Vector room = constantVector(underflow);
        const Number range = betweenNumber(hn::Sub(low, room), hn::Add(high, room));
        const Mask better = hn::And(isKnown(product), hn::Lt(range.e, product.e));
        return chooseNumber(hn::And(wide, better), range, product);
    }
};

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
