// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/evaluate/algebra/interval_gradient_rules.h"
#include "core/evaluate/interval_evaluator.h"

namespace isoscope::gradient_rules {

namespace {

const Interval one = Interval::point(1);

Interval times(double factor, const Interval& a) { return Interval::point(factor) * a; }

/// What stays finite of a value that runs to an end of its domain.
Derivatives derivatives(const Interval& first, const Interval& second) {
    if (first.empty()) return {SlopeRange::within(unlimited)};
    return {rangeOf(first), second.empty() ? SlopeRange::within(unlimited) : rangeOf(second)};
}

/// Of an expression that rises or falls everywhere but at -turn and turn, which are a rounding beside their
/// doubles at most: from its values there and at the ends, where that says more than one over all.
template <class Expression>
Interval betweenTurns(const Interval& x, double turn, Expression at) {
    const Interval whole = at(x);
    if (!std::isfinite(x.low) || !std::isfinite(x.high)) return whole;
    Interval ends = hull(at(Interval::point(x.low)), at(Interval::point(x.high)));
    for (const double center : {-turn, turn}) {
        const Interval around{center - 1e-15, center + 1e-15, false};
        if (x.low <= around.high && x.high >= around.low) ends = hull(ends, at(around));
    }
    return {std::max(whole.low, ends.low), std::min(whole.high, ends.high), whole.maybeUndefined};
}

IntervalGradient absoluteOf(const IntervalGradient& u) {
    if (u.value.empty() || u.value.low >= 0) return u;
    if (u.value.high <= 0) return scaled(u, -1);
    return magnitudeOf(u);
}

IntervalGradient logarithmOf(const IntervalGradient& u) {
    const Interval value = log(u.value);
    // At 0 it is -infinity, which comparisons take for a number.
    if (!(u.value.low > 0)) return chain(u, value, {SlopeRange::within(unlimited)}, GradientHazard::pole);
    const Interval inverse = one / u.value;
    IntervalGradient result = chain(u, value, derivatives(inverse, -square(inverse)), GradientHazard::pole);
    useLogarithm(u, result);
    return result;
}

/// sin or cos, of an angle without a cut or with one of whole turns.
IntervalGradient waveWithoutCut(const IntervalGradient& u, bool isSine) {
    const Interval sine = sin(u.value), cosine = cos(u.value);
    IntervalGradient wave = isSine ? chain(u, sine, derivatives(cosine, -sine), GradientHazard::overflow)
                                   : chain(u, cosine, derivatives(-sine, -cosine), GradientHazard::overflow);
    if (wave.hazard <= GradientHazard::jump && !wave.isConstant()) wave.angleSteepness = u.steepness;
    return wave;
}

/// sin or cos.
IntervalGradient waveOf(const IntervalGradient& u, bool isSine) {
    // A whole turn is none.
    if (u.wrap == 0 || isWhole(u.wrap, 2 * std::numbers::pi)) return waveWithoutCut(u, isSine);
    return acrossCut(u, !isSine, [&](const IntervalGradient& side) { return waveOf(side, isSine); });
}

/// sin(2 pi u).
IntervalGradient cycleOf(const IntervalGradient& u) {
    const std::array<Interval, 1> operand{u.value};
    const Interval value = evaluateOperation(Operation::cycle, operand);
    IntervalGradient wave = waveOf(scaled(u, 2 * std::numbers::pi), true);
    if (u.wrap == 0) wave.value = value;
    return wave;
}

IntervalGradient triangleWaveOf(const IntervalGradient& operand) {
    if (operand.wrap != 0 && !isWhole(operand.wrap, 1)) return acrossCut(operand, false, triangleWaveOf);
    const IntervalGradient u = withoutCut(operand);
    const std::array<Interval, 1> values{u.value};
    const Interval value = evaluateOperation(Operation::triangleWave, values);
    if (const double corner = cornerOf(u); !std::isnan(corner) && u.hazard <= GradientHazard::jump) {
        IntervalGradient result = aboutCorner(magnitudeOf(fromCorner(u, corner)), corner);
        result.value = value;
        return result;
    }
    const double half = std::floor(2 * u.value.low);
    const bool straight = half == std::floor(2 * u.value.high);
    if (!straight) return chain(u, value, {SlopeRange::within(2)}, GradientHazard::overflow);
    const double slope = std::fmod(half, 2) == 0 ? 2 : -2;
    return chain(u, value, {{slope, slope}, {0, 0}}, GradientHazard::overflow);
}

/// asin, and with the sign turned acos: slope 1 / sqrt(1 - u^2).
IntervalGradient arcOf(const IntervalGradient& u, const Interval& value, double sign) {
    const Interval inside = (one - u.value) * (one + u.value);
    if (!(inside.low > 0)) return chain(u, value, {SlopeRange::within(unlimited)}, GradientHazard::steepEdge);
    const Interval first = one / sqrt(inside);
    return chain(u, value, derivatives(times(sign, first), times(sign, u.value * first / inside)),
                 GradientHazard::steepEdge);
}

/// tanh and the inverse hyperbolic functions.
IntervalGradient areaOf(Operation operation, const IntervalGradient& u) {
    const Interval& x = u.value;
    if (operation == Operation::hyperbolicTangent) {
        const auto firstAt = [](const Interval& value) { return (one - value) * (one + value); };
        const Interval value = tanh(x);
        const Interval first = betweenTurns(value, 0, firstAt);
        const Interval second = betweenTurns(value, std::sqrt(1.0 / 3),
                                             [&](const Interval& v) { return times(-2, v * firstAt(v)); });
        return chain(u, value, derivatives(first, second), GradientHazard::overflow);
    }
    if (operation == Operation::areaSine) {
        const auto firstAt = [](const Interval& a) { return one / sqrt(one + square(a)); };
        const Interval second = betweenTurns(
            x, std::sqrt(0.5), [&](const Interval& a) { return -(a * firstAt(a) / (one + square(a))); });
        return chain(u, asinh(x), derivatives(firstAt(x), second), GradientHazard::overflow);
    }
    if (operation == Operation::areaCosine) {
        const Interval inside = (x - one) * (x + one);
        if (!(x.low > 1 && inside.low > 0))
            return chain(u, acosh(x), {SlopeRange::within(unlimited)}, GradientHazard::steepEdge);
        const Interval first = one / sqrt(inside);
        return chain(u, acosh(x), derivatives(first, -(x * first / inside)), GradientHazard::steepEdge);
    }
    const Interval inside = (one - x) * (one + x);
    if (!(inside.low > 0)) return chain(u, atanh(x), {SlopeRange::within(unlimited)}, GradientHazard::pole);
    const Interval first = one / inside;
    return chain(u, atanh(x), derivatives(first, times(2, x * square(first))), GradientHazard::pole);
}

}  // namespace

IntervalGradient magnitudeOf(const IntervalGradient& u) {
    IntervalGradient result = either(u, scaled(u, -1), abs(u.value));
    if (result.hazard > GradientHazard::jump || result.isConstant()) return result;
    result.rootExponent = 1;
    result.rootSteepness = u.steepness;
    result.root = rootOf(u);
    return result;
}

bool isWhole(double wrap, double period) {
    const double turns = wrap / period;
    return std::abs(turns - std::round(turns)) <= 1e-12 * std::abs(turns);
}

IntervalGradient withoutCut(const IntervalGradient& u) {
    IntervalGradient result = u;
    result.wrap = 0;
    return result;
}

IntervalGradient elementary(Operation operation, const IntervalGradient& operand) {
    if (operation == Operation::negate) return scaled(operand, -1);
    if (operation == Operation::sine || operation == Operation::cosine)
        return waveOf(operand, operation == Operation::sine);
    if (operation == Operation::cycle) return cycleOf(operand);
    if (operation == Operation::triangleWave) return triangleWaveOf(operand);
    const IntervalGradient& u = operand;
    const Interval& x = u.value;
    switch (operation) {
        case Operation::absolute: return absoluteOf(u);
        case Operation::square: return squareOf(u);
        case Operation::squareRoot: return squareRootOf(u);
        case Operation::exponential: {
            const Interval value = exp(x);
            IntervalGradient result = chain(u, value, derivatives(value, value), GradientHazard::overflow);
            useExponential(rootOf(u), u.steepness, result);
            return result;
        }
        case Operation::naturalLogarithm: return logarithmOf(u);
        case Operation::decimalLogarithm: {
            // 1 / ln 10 is itself rounded.
            IntervalGradient result = logarithmOf(u);
            if (result.value.empty() || result.isConstant()) return constant(log10(x));
            result = scaled(result, std::nextafter(std::numbers::log10e, 1));
            result.value = log10(x);
            for (SlopeRange& slope : result.slope) slope = hull(slope, (1 - 0x1p-51) * slope);
            for (SlopeRange& bend : result.bend) bend = hull(bend, (1 - 0x1p-51) * bend);
            return result;
        }
        case Operation::tangent: {
            const Interval value = tan(x), first = one + square(value);
            return chain(u, value, derivatives(first, times(2, value * first)), GradientHazard::pole);
        }
        case Operation::arcSine: return arcOf(u, asin(x), 1);
        case Operation::arcCosine: return arcOf(u, acos(x), -1);
        case Operation::arcTangent: {
            const auto firstAt = [](const Interval& a) { return one / (one + square(a)); };
            const Interval second = betweenTurns(
                x, std::sqrt(1.0 / 3), [&](const Interval& a) { return times(-2, a * square(firstAt(a))); });
            return chain(u, atan(x), derivatives(firstAt(x), second), GradientHazard::overflow);
        }
        case Operation::hyperbolicSine:
            return chain(u, sinh(x), derivatives(cosh(x), sinh(x)), GradientHazard::overflow);
        case Operation::hyperbolicCosine:
            return chain(u, cosh(x), derivatives(sinh(x), cosh(x)), GradientHazard::overflow);
        default: return areaOf(operation, u);
    }
}

IntervalGradient arcTangent2Of(const IntervalGradient& a, const IntervalGradient& b) {
    const Interval& y = a.value;
    const Interval& x = b.value;
    if (a.isConstant() && b.isConstant()) return constant(atan2(y, x));
    const std::uint8_t axes = a.axes | b.axes;
    const Interval square2 = square(y) + square(x);
    if (square2.empty()) return undefinedEverywhere();
    if (!(square2.low > 0)) return hazardous(atan2(y, x), axes, GradientHazard::pole);
    const bool cut = y.low <= 0 && y.high >= 0 && x.low <= 0;
    // Around the cut the angle is measured from the opposite direction, where it is continuous.
    const Interval half{std::nextafter(std::numbers::pi, 3), std::nextafter(std::numbers::pi, 4), false};
    const Interval value = cut ? half + atan2(-y, -x) : atan2(y, x);
    const Interval inverse = one / square2, inverse2 = square(inverse);
    const Interval mixed = (square(y) - square(x)) * inverse2, bend = times(2, x * y * inverse2);
    const TwoDerivatives h{rangeOf(x * inverse), rangeOf(-(y * inverse)), rangeOf(-bend), rangeOf(mixed),
                           rangeOf(bend)};
    IntervalGradient result = chain(a, b, value, h, GradientHazard::pole);
    // The angle turns by 1 / distance of what the point moves.
    const double stretch =
        (a.axes & b.axes) == 0 ? std::max(a.steepness, b.steepness) : raised(a.steepness + b.steepness);
    if (result.bounded()) {
        result.steepness = std::min(result.steepness, raised(raised(1 / rootBelow(square2.low)) * stretch));
        settle(result);
    }
    if (cut && result.bounded()) {
        result.wrap = 2 * std::numbers::pi;
        result.cutAt = std::numbers::pi;
    }
    if (cut && !result.bounded()) result.value = atan2(y, x);
    return result;
}

IntervalGradient quotient(const IntervalGradient& a, const IntervalGradient& b) {
    const bool byConstant = b.isConstant() && b.value.isPoint();
    if (b.wrap != 0 || (a.wrap != 0 && !byConstant)) return quotient(resolveWrap(a), resolveWrap(b));
    const Interval value = a.value / b.value;
    const std::uint8_t axes = a.axes | b.axes;
    if (axes == 0) return constant(value);
    if (a.value.empty() || b.value.empty()) return undefinedEverywhere();
    if (b.value.low <= 0 && b.value.high >= 0) return hazardous(value, axes, GradientHazard::pole);
    const Interval inverse = one / b.value, inverse2 = square(inverse);
    const Interval slope = -(value * inverse);
    const TwoDerivatives h{
        rangeOf(inverse), rangeOf(slope), {}, rangeOf(-inverse2), rangeOf(times(-2, slope * inverse))};
    IntervalGradient result = chain(a, b, value, h, GradientHazard::overflow);
    if (a.wrap != 0) {
        result.wrap = a.wrap / b.value.low;
        result.cutAt = a.cutAt / b.value.low;
    }
    if (b.isConstant() && b.value.low > 0 && a.isSumOfPowers() && result.bounded()) {
        result.rootExponent = a.rootExponent;
        result.rootSteepness =
            raised(a.rootSteepness * std::pow(inverse.high, 1 / a.rootExponent) * (1 + 1e-14));
        result.root = scaledRoot(a.root, inverse, a.rootExponent);
        for (std::size_t k = 0; k < 6; ++k) result.rootSpread[k] = rangeOf(inverse) * a.rootSpread[k];
    }
    if (b.sumsExponentials && b.root.known && a.isConstant() && a.value.isPoint() && a.value.low > 0)
        useExponential(movedRoot(b.root, -1, log(a.value)), b.rootSteepness, result);
    return result;
}

IntervalGradient power(const IntervalGradient& base, const IntervalGradient& exponent) {
    if (exponent.isConstant() && exponent.value.isPoint()) return powerOf(base, exponent.value.low);
    const Interval value = pow(base.value, exponent.value);
    if (base.isConstant() && exponent.isConstant()) return constant(value);
    if (value.empty()) return undefinedEverywhere();
    // To the power 0 it is 1, whether the base has a value or not.
    if (base.value.empty() || exponent.value.empty() || !(base.value.low > 0))
        return hazardous(value, base.axes | exponent.axes, GradientHazard::steepEdge);
    const IntervalGradient logarithm = elementary(Operation::naturalLogarithm, base);
    return elementary(Operation::exponential, product(exponent, logarithm));
}

}  // namespace isoscope::gradient_rules
