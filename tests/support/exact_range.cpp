// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/exact_range.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isoscope::test {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Angles beyond are not reduced.
constexpr mpfr_exp_t largestAngle = 2000;

using Unary = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);
using Binary = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);

ExactRange between(double low, double high) { return {ExactNumber(low), ExactNumber(high)}; }

bool less(const ExactNumber& a, const ExactNumber& b) { return mpfr_less_p(a.get(), b.get()) != 0; }

ExactRange hull(const ExactRange& a, const ExactRange& b) {
    ExactRange result{less(b.low, a.low) ? b.low : a.low, less(a.high, b.high) ? b.high : a.high};
    result.maybeUndefined = a.maybeUndefined || b.maybeUndefined;
    return result;
}

ExactRange negated(const ExactRange& a) {
    ExactRange result;
    mpfr_neg(result.low.get(), a.high.get(), MPFR_RNDD);
    mpfr_neg(result.high.get(), a.low.get(), MPFR_RNDU);
    result.maybeUndefined = a.maybeUndefined;
    return result;
}

/// Of a function that never falls.
ExactRange rising(Unary function, const ExactRange& a) {
    ExactRange result;
    function(result.low.get(), a.low.get(), MPFR_RNDD);
    function(result.high.get(), a.high.get(), MPFR_RNDU);
    result.maybeUndefined = a.maybeUndefined;
    return result;
}

/// The largest and the smallest of what `function` makes of the corners; 0 times infinity is 0.
ExactRange ofCorners(Binary function, const ExactRange& a, const ExactRange& b) {
    ExactRange result = between(infinity, -infinity);
    ExactNumber corner;
    for (const ExactNumber* x : {&a.low, &a.high})
        for (const ExactNumber* y : {&b.low, &b.high}) {
            function(corner.get(), x->get(), y->get(), MPFR_RNDD);
            if (corner.isNan()) mpfr_set_zero(corner.get(), 1);
            mpfr_min(result.low.get(), result.low.get(), corner.get(), MPFR_RNDD);
            function(corner.get(), x->get(), y->get(), MPFR_RNDU);
            if (corner.isNan()) mpfr_set_zero(corner.get(), 1);
            mpfr_max(result.high.get(), result.high.get(), corner.get(), MPFR_RNDU);
        }
    result.maybeUndefined = a.maybeUndefined || b.maybeUndefined;
    return result;
}

ExactRange absolute(const ExactRange& a) {
    if (!a.isNegative() && mpfr_sgn(a.low.get()) >= 0) return a;
    ExactRange mirrored = negated(a);
    if (mpfr_sgn(a.high.get()) <= 0) return mirrored;
    ExactRange result{ExactNumber(0.0), less(a.high, mirrored.high) ? mirrored.high : a.high};
    result.maybeUndefined = a.maybeUndefined;
    return result;
}

ExactRange square(const ExactRange& a) { return rising(mpfr_sqr, absolute(a)); }

ExactRange quotient(const ExactRange& a, const ExactRange& b) {
    if (!b.isPositive() && !b.isNegative()) {
        ExactRange result = ExactRange::all();
        result.maybeUndefined = true;
        return result;
    }
    return ofCorners(mpfr_div, a, b);
}

/// The part of `a` within [low, high], outside of which a function has no value.
ExactRange domain(const ExactRange& a, double low, double high) {
    ExactRange result = a;
    if (mpfr_cmp_d(a.low.get(), low) < 0) {
        mpfr_set_d(result.low.get(), low, MPFR_RNDD);
        result.maybeUndefined = true;
    }
    if (mpfr_cmp_d(a.high.get(), high) > 0) {
        mpfr_set_d(result.high.get(), high, MPFR_RNDU);
        result.maybeUndefined = true;
    }
    // No value at all.
    if (less(result.high, result.low)) result.high = result.low;
    return result;
}

/// floor(a / pi + shift) at both ends of the range, outward.
void halfTurns(const ExactRange& a, double shift, ExactNumber& first, ExactNumber& last) {
    ExactNumber piLow, piHigh;
    mpfr_const_pi(piLow.get(), MPFR_RNDD);
    mpfr_const_pi(piHigh.get(), MPFR_RNDU);
    ExactRange turns = quotient(a, {piLow, piHigh});
    turns = turns + between(shift, shift);
    mpfr_floor(first.get(), turns.low.get());
    mpfr_floor(last.get(), turns.high.get());
}

bool isHugeAngle(const ExactRange& a) {
    const auto huge = [](const ExactNumber& n) {
        return !n.isFinite() || (mpfr_regular_p(n.get()) != 0 && mpfr_get_exp(n.get()) > largestAngle);
    };
    return huge(a.low) || huge(a.high);
}

/// Sine or cosine, which turn where angle / pi + shift is a whole number: at 1 where it is even, at -1 where
/// odd.
ExactRange wave(Unary function, double shift, const ExactRange& a) {
    ExactRange result = between(-1, 1);
    result.maybeUndefined = a.maybeUndefined;
    if (isHugeAngle(a)) return result;
    ExactNumber first, last, passed;
    halfTurns(a, shift, first, last);
    mpfr_sub(passed.get(), last.get(), first.get(), MPFR_RNDN);
    if (mpfr_cmp_si(passed.get(), 1) > 0) return result;
    ExactRange begin, end;
    function(begin.low.get(), a.low.get(), MPFR_RNDD);
    function(begin.high.get(), a.low.get(), MPFR_RNDU);
    function(end.low.get(), a.high.get(), MPFR_RNDD);
    function(end.high.get(), a.high.get(), MPFR_RNDU);
    ExactRange ends = hull(begin, end);
    ends.maybeUndefined = a.maybeUndefined;
    if (mpfr_sgn(passed.get()) == 0) return ends;
    ExactNumber half;
    mpfr_div_2ui(half.get(), last.get(), 1, MPFR_RNDN);
    if (mpfr_integer_p(half.get()) != 0)
        mpfr_set_si(ends.high.get(), 1, MPFR_RNDU);
    else
        mpfr_set_si(ends.low.get(), -1, MPFR_RNDD);
    return ends;
}

ExactRange cosine(const ExactRange& a) { return wave(mpfr_cos, 0, a); }
ExactRange sine(const ExactRange& a) { return wave(mpfr_sin, -0.5, a); }

ExactRange halfPi() {
    ExactRange result;
    mpfr_const_pi(result.low.get(), MPFR_RNDD);
    mpfr_const_pi(result.high.get(), MPFR_RNDU);
    mpfr_div_2ui(result.low.get(), result.low.get(), 1, MPFR_RNDD);
    mpfr_div_2ui(result.high.get(), result.high.get(), 1, MPFR_RNDU);
    return result;
}

ExactRange tangent(const ExactRange& a) {
    ExactRange result = ExactRange::all();
    result.maybeUndefined = a.maybeUndefined;
    if (isHugeAngle(a)) return result;
    ExactNumber first, last;
    halfTurns(a, 0.5, first, last);
    return mpfr_equal_p(first.get(), last.get()) != 0 ? rising(mpfr_tan, a) : result;
}

int floored(mpfr_ptr r, mpfr_srcptr a, mpfr_rnd_t) { return mpfr_floor(r, a); }
int ceiled(mpfr_ptr r, mpfr_srcptr a, mpfr_rnd_t) { return mpfr_ceil(r, a); }
int truncated(mpfr_ptr r, mpfr_srcptr a, mpfr_rnd_t) { return mpfr_trunc(r, a); }

/// Through a 32-bit integer.
ExactRange truncate32(const ExactRange& a) {
    const ExactRange result = rising(truncated, a);
    const bool fits = mpfr_cmp_d(result.low.get(), -2147483648.0) >= 0 &&
                      mpfr_cmp_d(result.high.get(), 2147483647.0) <= 0 && !a.maybeUndefined;
    return fits ? result : between(-2147483648.0, 2147483647.0);
}

ExactRange fraction(const ExactRange& a) {
    const ExactRange step = rising(floored, a);
    if (step.isPoint() && step.isBounded()) return common(a - step, between(0, 1));
    ExactRange result = between(0, 1);
    result.maybeUndefined = a.maybeUndefined || !a.isBounded();
    return result;
}

ExactRange triangleWave(const ExactRange& a) {
    const ExactRange part = fraction(a);
    const ExactRange down = between(1, 1) - part;
    ExactRange result{less(down.low, part.low) ? down.low : part.low,
                      less(part.high, down.high) ? part.high : down.high};
    if (mpfr_cmp_d(result.high.get(), 0.5) > 0) mpfr_set_d(result.high.get(), 0.5, MPFR_RNDU);
    result.maybeUndefined = part.maybeUndefined;
    return between(2, 2) * result;
}

bool isWhole(const ExactRange& a) { return a.isPoint() && mpfr_integer_p(a.low.get()) != 0; }

/// a^n for a whole number n.
ExactRange wholePower(const ExactRange& a, const ExactNumber& n) {
    const auto raised = [&](const ExactRange& base) {
        ExactRange result;
        mpfr_pow(result.low.get(), base.low.get(), n.get(), MPFR_RNDD);
        mpfr_pow(result.high.get(), base.high.get(), n.get(), MPFR_RNDU);
        result.maybeUndefined = base.maybeUndefined;
        return result;
    };
    if (mpfr_sgn(n.get()) < 0) {
        ExactNumber positive;
        mpfr_neg(positive.get(), n.get(), MPFR_RNDN);
        return quotient(between(1, 1), wholePower(a, positive));
    }
    ExactNumber half;
    mpfr_div_2ui(half.get(), n.get(), 1, MPFR_RNDN);
    return raised(mpfr_integer_p(half.get()) != 0 ? absolute(a) : a);
}

ExactRange power(const ExactRange& a, const ExactRange& b) {
    if (isWhole(b)) return wholePower(a, b.low);
    if (a.isPositive()) return rising(mpfr_exp, b * rising(mpfr_log, a));
    if (mpfr_sgn(a.low.get()) >= 0 && b.isPositive()) {
        // From 0 to the largest base raised to either end.
        ExactRange top{a.high, a.high};
        ExactRange result(0.0);
        if (mpfr_sgn(a.high.get()) > 0) result = rising(mpfr_exp, b * rising(mpfr_log, top));
        mpfr_set_zero(result.low.get(), 1);
        result.maybeUndefined = a.maybeUndefined || b.maybeUndefined;
        return result;
    }
    ExactRange result = ExactRange::all();
    result.maybeUndefined = true;
    return result;
}

/// Whether the ranges keep away from the cut along x <= 0, y = 0.
bool avoidsCut(const ExactRange& y, const ExactRange& x) {
    return x.isPositive() || y.isPositive() || y.isNegative();
}

ExactRange angle(const ExactRange& y, const ExactRange& x) {
    // The farthest angles of a box are those of corners.
    if (avoidsCut(y, x)) return ofCorners(mpfr_atan2, y, x);
    ExactRange half = halfPi();
    ExactRange result{ExactNumber(), half.high};
    mpfr_mul_2ui(result.high.get(), result.high.get(), 1, MPFR_RNDU);
    mpfr_neg(result.low.get(), result.high.get(), MPFR_RNDD);
    result.maybeUndefined = y.maybeUndefined || x.maybeUndefined;
    return result;
}

/// trunc(a / b) where it is the same all over the ranges; else nothing.
bool wholeQuotient(const ExactRange& a, const ExactRange& b, ExactNumber& whole) {
    const ExactRange exact = quotient(a, b);
    if (exact.maybeUndefined || !exact.isBounded()) return false;
    const ExactRange steps = rising(truncated, exact);
    whole = steps.low;
    return steps.isPoint();
}

ExactRange remainder(const ExactRange& a, const ExactRange& b) {
    ExactNumber whole;
    if (wholeQuotient(a, b, whole)) return a - ExactRange(whole, whole) * b;
    const ExactRange size = absolute(b);
    ExactRange result{ExactNumber(0.0), ExactNumber(0.0)};
    if (!a.isPositive()) mpfr_neg(result.low.get(), size.high.get(), MPFR_RNDD);
    if (!a.isNegative()) result.high = size.high;
    result.maybeUndefined = a.maybeUndefined || b.maybeUndefined || b.holds(0) || !a.isBounded();
    return result;
}

/// 0 or 1, or both.
ExactRange truth(bool maybeFalse, bool maybeTrue) { return between(maybeFalse ? 0 : 1, maybeTrue ? 1 : 0); }

ExactRange comparison(Operation operation, const ExactRange& a, const ExactRange& b) {
    if (a.maybeUndefined || b.maybeUndefined) return truth(true, true);
    const bool below = mpfr_less_p(a.low.get(), b.high.get()) != 0;
    const bool above = mpfr_greater_p(a.high.get(), b.low.get()) != 0;
    const bool same =
        mpfr_lessequal_p(a.low.get(), b.high.get()) != 0 && mpfr_lessequal_p(b.low.get(), a.high.get()) != 0;
    switch (operation) {
        case Operation::less: return truth(above || same, below);
        case Operation::lessEqual: return truth(above, below || same);
        case Operation::greater: return truth(below || same, above);
        case Operation::greaterEqual: return truth(below, above || same);
        case Operation::equal: return truth(below || above, same);
        case Operation::notEqual: return truth(same, below || above);
        default: break;
    }
    const auto isZero = [](const ExactRange& r) { return r.isPoint() && r.holds(0); };
    if (operation == Operation::logicalAnd) return truth(a.holds(0) || b.holds(0), !isZero(a) && !isZero(b));
    return truth(a.holds(0) && b.holds(0), !isZero(a) || !isZero(b));
}

/// The smaller; with NaN the second.
ExactRange minimum(const ExactRange& a, const ExactRange& b) {
    if (a.maybeUndefined || b.maybeUndefined) return hull(a, b);
    return {less(b.low, a.low) ? b.low : a.low, less(b.high, a.high) ? b.high : a.high};
}

/// A jet with no more than its values.
ExactJet unsloped(const ExactRange& value) { return {value, ExactRange::all(), false}; }

/// A jet by the chain rule.
ExactJet chained(const ExactRange& value, const ExactRange& derivative, const ExactJet& a) {
    const ExactRange slope = derivative * a.slope;
    const bool sloped =
        a.isSloped && !value.maybeUndefined && !derivative.maybeUndefined && derivative.isBounded();
    return {value, slope, sloped};
}

ExactJet stepped(const ExactRange& value, bool continuous, const ExactRange& slope) {
    return {value, slope, continuous && value.isBounded() && !value.maybeUndefined};
}

ExactJet absoluteOf(const ExactJet& a) {
    const ExactRange value = absolute(a.value);
    const ExactRange side = a.value.isPositive()   ? between(1, 1)
                            : a.value.isNegative() ? between(-1, -1)
                                                   : between(-1, 1);
    return chained(value, side, a);
}

ExactRange reciprocal(const ExactRange& a) { return quotient(between(1, 1), a); }

ExactJet elementary(Operation operation, const ExactJet& jet) {
    const ExactRange& a = jet.value;
    const ExactRange one = between(1, 1);
    switch (operation) {
        case Operation::negate: return {negated(a), negated(jet.slope), jet.isSloped};
        case Operation::absolute: return absoluteOf(jet);
        case Operation::square: return chained(square(a), between(2, 2) * a, jet);
        case Operation::squareRoot: {
            const ExactRange root = rising(mpfr_sqrt, domain(a, 0, infinity));
            return chained(root, reciprocal(between(2, 2) * root), jet);
        }
        case Operation::exponential: {
            const ExactRange value = rising(mpfr_exp, a);
            return chained(value, value, jet);
        }
        case Operation::naturalLogarithm:
            return chained(rising(mpfr_log, domain(a, 0, infinity)), reciprocal(a), jet);
        case Operation::decimalLogarithm:
            return chained(rising(mpfr_log10, domain(a, 0, infinity)),
                           reciprocal(a * rising(mpfr_log, between(10, 10))), jet);
        case Operation::sine: return chained(sine(a), cosine(a), jet);
        case Operation::cosine: return chained(cosine(a), negated(sine(a)), jet);
        case Operation::tangent: {
            const ExactRange value = tangent(a);
            return chained(value, one + square(value), jet);
        }
        case Operation::arcSine: {
            const ExactRange within = domain(a, -1, 1);
            return chained(rising(mpfr_asin, within),
                           reciprocal(rising(mpfr_sqrt, domain(one - square(a), 0, infinity))), jet);
        }
        case Operation::arcCosine: {
            const ExactRange within = domain(a, -1, 1);
            const ExactRange mirrored{within.high, within.low};
            ExactRange value = rising(mpfr_acos, mirrored);
            value.maybeUndefined = within.maybeUndefined;
            return chained(value,
                           negated(reciprocal(rising(mpfr_sqrt, domain(one - square(a), 0, infinity)))), jet);
        }
        case Operation::arcTangent: return chained(rising(mpfr_atan, a), reciprocal(one + square(a)), jet);
        case Operation::hyperbolicSine:
            return chained(rising(mpfr_sinh, a), rising(mpfr_cosh, absolute(a)), jet);
        case Operation::hyperbolicCosine:
            return chained(rising(mpfr_cosh, absolute(a)), rising(mpfr_sinh, a), jet);
        case Operation::hyperbolicTangent: {
            const ExactRange value = rising(mpfr_tanh, a);
            return chained(value, one - square(value), jet);
        }
        case Operation::areaSine:
            return chained(rising(mpfr_asinh, a), reciprocal(rising(mpfr_sqrt, one + square(a))), jet);
        case Operation::areaCosine:
            return chained(rising(mpfr_acosh, domain(a, 1, infinity)),
                           reciprocal(rising(mpfr_sqrt, domain(square(a) - one, 0, infinity))), jet);
        default: return chained(rising(mpfr_atanh, domain(a, -1, 1)), reciprocal(one - square(a)), jet);
    }
}

ExactJet periodic(Operation operation, const ExactJet& jet) {
    const ExactRange& a = jet.value;
    const auto flat = [](const ExactRange& value) {
        return stepped(value, value.isPoint(), ExactRange(0.0));
    };
    switch (operation) {
        case Operation::floor: return flat(rising(floored, a));
        case Operation::ceiling: return flat(rising(ceiled, a));
        case Operation::truncate: return flat(truncate32(a));
        case Operation::fraction: {
            const bool whole = rising(floored, a).isPoint();
            return {fraction(a), jet.slope, jet.isSloped && whole};
        }
        case Operation::triangleWave: return chained(triangleWave(a), between(-2, 2), jet);
        default: {
            const ExactRange turn = between(4, 4) * halfPi();
            return chained(sine(turn * a), turn * cosine(turn * a), jet);
        }
    }
}

ExactJet powerOf(const ExactJet& a, const ExactJet& b) {
    const ExactRange value = power(a.value, b.value);
    // At a point every exponent is one.
    const bool isConstant = b.isSloped && b.value.isPoint() && b.slope.isPoint() && b.slope.holds(0);
    if (isConstant && (a.value.isPositive() || isWhole(b.value))) {
        const ExactRange less = b.value - between(1, 1);
        return chained(value, b.value * power(a.value, less), a);
    }
    if (!a.value.isPositive()) return unsloped(value);
    const ExactRange slope =
        value * (b.slope * rising(mpfr_log, a.value) + b.value * quotient(a.slope, a.value));
    return {value, slope, a.isSloped && b.isSloped && !value.maybeUndefined};
}

ExactJet choice(const ExactJet& a, const ExactJet& b, bool takesMinimum) {
    const ExactRange value =
        takesMinimum ? minimum(a.value, b.value) : negated(minimum(negated(a.value), negated(b.value)));
    if (a.value.maybeUndefined || b.value.maybeUndefined) return unsloped(hull(a.value, b.value));
    if (less(a.value.high, b.value.low)) return takesMinimum ? a : b;
    if (less(b.value.high, a.value.low)) return takesMinimum ? b : a;
    return {value, hull(a.slope, b.slope), a.isSloped && b.isSloped};
}

ExactJet binary(Operation operation, const ExactJet& a, const ExactJet& b) {
    const bool sloped = a.isSloped && b.isSloped;
    switch (operation) {
        case Operation::add: return {a.value + b.value, a.slope + b.slope, sloped};
        case Operation::subtract: return {a.value - b.value, a.slope - b.slope, sloped};
        case Operation::multiply: return {a.value * b.value, a.slope * b.value + a.value * b.slope, sloped};
        case Operation::divide: {
            const ExactRange value = quotient(a.value, b.value);
            return {value, quotient(a.slope - value * b.slope, b.value), sloped && !value.maybeUndefined};
        }
        case Operation::power: return powerOf(a, b);
        case Operation::arcTangent2: {
            const ExactRange value = angle(a.value, b.value);
            const ExactRange rise = b.value * a.slope - a.value * b.slope;
            return {value, quotient(rise, square(a.value) + square(b.value)),
                    sloped && avoidsCut(a.value, b.value)};
        }
        case Operation::remainder: {
            ExactNumber whole;
            const bool smooth = wholeQuotient(a.value, b.value, whole);
            return {remainder(a.value, b.value),
                    smooth ? a.slope - ExactRange(whole, whole) * b.slope : ExactRange::all(),
                    sloped && smooth};
        }
        case Operation::integerDivide: {
            const ExactRange value = truncate32(quotient(a.value, b.value));
            return stepped(value, value.isPoint(), ExactRange(0.0));
        }
        case Operation::minimum: return choice(a, b, true);
        case Operation::maximum: return choice(a, b, false);
        default: {
            const ExactRange value = comparison(operation, a.value, b.value);
            return stepped(value, value.isPoint(), ExactRange(0.0));
        }
    }
}

/// Of select3 and select4: the hull of what may be chosen.
ExactJet selection(std::span<const ExactJet* const> operands) {
    const ExactRange& a = operands[0]->value;
    const bool maybeNegative =
        mpfr_sgn(a.low.get())<0, maybeZero = a.holds(0), maybePositive = mpfr_sgn(a.high.get())> 0 ||
        a.maybeUndefined;
    const bool four = operands.size() == 4;
    const std::array<bool, 3> chosen{maybeNegative, four ? maybeZero : maybeZero || maybePositive,
                                     four && maybePositive};
    const ExactJet* first = nullptr;
    ExactJet result;
    int count = 0;
    for (std::size_t k = 0; k + 1 < operands.size(); ++k) {
        if (!chosen[k]) continue;
        result = first == nullptr ? *operands[k + 1] : unsloped(hull(result.value, operands[k + 1]->value));
        first = operands[k + 1];
        ++count;
    }
    if (count == 1 && !a.maybeUndefined) return result;
    return unsloped(result.value);
}

}  // namespace

ExactRange::ExactRange(double value) : low(value), high(value) {
    if (!std::isnan(value)) return;
    *this = all();
    maybeUndefined = true;
}

ExactRange ExactRange::all() { return between(-infinity, infinity); }

bool ExactRange::holds(double value) const {
    return mpfr_cmp_d(low.get(), value) <= 0 && mpfr_cmp_d(high.get(), value) >= 0;
}

ExactJet ExactJet::constant(double value) {
    return {ExactRange(value), ExactRange(0.0), std::isfinite(value)};
}

ExactRange common(const ExactRange& a, const ExactRange& b) {
    ExactRange result{less(a.low, b.low) ? b.low : a.low, less(b.high, a.high) ? b.high : a.high};
    result.maybeUndefined = a.maybeUndefined || b.maybeUndefined;
    return result;
}

ExactRange operator+(const ExactRange& a, const ExactRange& b) {
    ExactRange result;
    mpfr_add(result.low.get(), a.low.get(), b.low.get(), MPFR_RNDD);
    mpfr_add(result.high.get(), a.high.get(), b.high.get(), MPFR_RNDU);
    // Infinities of both signs.
    if (result.low.isNan()) mpfr_set_inf(result.low.get(), -1);
    if (result.high.isNan()) mpfr_set_inf(result.high.get(), 1);
    result.maybeUndefined = a.maybeUndefined || b.maybeUndefined;
    return result;
}

ExactRange operator-(const ExactRange& a, const ExactRange& b) { return a + negated(b); }

ExactRange operator*(const ExactRange& a, const ExactRange& b) { return ofCorners(mpfr_mul, a, b); }

bool hasExactRule(Operation operation) {
    const int count = arity(operation);
    if (count == 1 || count == 2) return true;
    return operation == Operation::select3 || operation == Operation::select4;
}

ExactJet enclose(Operation operation, std::span<const ExactJet* const> operands) {
    if (operands.size() == 2) return binary(operation, *operands[0], *operands[1]);
    if (operands.size() > 2) return selection(operands);
    switch (operation) {
        case Operation::floor:
        case Operation::ceiling:
        case Operation::truncate:
        case Operation::fraction:
        case Operation::triangleWave:
        case Operation::cycle: return periodic(operation, *operands[0]);
        default: return elementary(operation, *operands[0]);
    }
}

}  // namespace isoscope::test
