// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/algebra/interval_gradient.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "core/evaluate/algebra/interval_gradient_rules.h"

namespace isoscope::gradient_rules {

namespace {

/// At least the length of u + v, for vectors in these ranges that are no longer than `longestU` and
/// `longestV`; `common` are the axes along which both may have components.
double lengthOfSum(const std::array<SlopeRange, 3>& u, double longestU, const std::array<SlopeRange, 3>& v,
                   double longestV, std::uint8_t common) {
    double twiceDot = 0;
    for (std::size_t i = 0; i < 3; ++i)
        if (dependsOn(common, i)) twiceDot = raised(twiceDot + 2 * (u[i] * v[i]).high);
    const double squares = raised(raised(longestU * longestU) + raised(longestV * longestV));
    return std::min(raised(longestU + longestV), rootAbove(raised(squares + twiceDot)));
}

bool sameExponent(double a, double b) { return std::abs(a - b) <= sameExponents * a; }

}  // namespace

IntervalGradient constant(const Interval& value) {
    IntervalGradient result;
    result.value = value;
    return result;
}

IntervalGradient undefinedEverywhere() { return constant(Interval::undefined()); }

IntervalGradient coordinate(std::size_t axis, const Interval& range) {
    IntervalGradient result = constant(range);
    result.axes = static_cast<std::uint8_t>(1 << axis);
    result.origin = static_cast<std::int8_t>(axis + 1);
    result.slope[axis] = {1, 1};
    result.steepness = 1;
    return result;
}

IntervalGradient hazardous(const Interval& value, std::uint8_t axes, GradientHazard hazard) {
    IntervalGradient result = constant(value);
    result.axes = axes;
    result.hazard = hazard;
    result.smooth = false;
    for (std::size_t i = 0; i < 3; ++i)
        if (dependsOn(axes, i)) result.slope[i] = SlopeRange::within(unlimited);
    result.steepness = unlimited;
    return result;
}

double lengthAbove(const std::array<SlopeRange, 3>& v) {
    double sum = 0;
    for (const SlopeRange& range : v)
        if (!range.isZero()) sum = raised(sum + raised(range.size() * range.size()));
    return rootAbove(sum);
}

double lengthBelow(const std::array<SlopeRange, 3>& v) {
    double sum = 0;
    for (const SlopeRange& range : v)
        sum = std::max(0.0, lowered(sum + std::max(0.0, lowered(range.gap() * range.gap()))));
    return rootBelow(sum);
}

namespace {

using SymmetricMatrix = std::array<double, 6>;

/// The largest eigenvalue, nearly: the roots of a cubic by angles.
double eigenvalueNear(const SymmetricMatrix& m) {
    const auto at = [&](std::size_t i, std::size_t j) { return m[bendIndex(i, j)]; };
    const double middle = (at(0, 0) + at(1, 1) + at(2, 2)) / 3;
    const double a = at(0, 0) - middle, b = at(1, 1) - middle, c = at(2, 2) - middle;
    const double besides = at(0, 1) * at(0, 1) + at(0, 2) * at(0, 2) + at(1, 2) * at(1, 2);
    const double spread = std::sqrt((a * a + b * b + c * c + 2 * besides) / 6);
    if (!(spread > 0)) return middle;
    const double determinant = a * (b * c - at(1, 2) * at(1, 2)) -
                               at(0, 1) * (at(0, 1) * c - at(1, 2) * at(0, 2)) +
                               at(0, 2) * (at(0, 1) * at(1, 2) - b * at(0, 2));
    const double cosine = std::clamp(determinant / (2 * spread * spread * spread), -1.0, 1.0);
    return middle + 2 * spread * std::cos(std::acos(cosine) / 3);
}

/// Whether no eigenvalue is as large as `bound`, for certain: the minors of the difference are above 0 by
/// more than their roundings.
bool isAboveEigenvalues(const SymmetricMatrix& m, double bound) {
    double largest = bound;
    for (const double entry : m) largest = std::max(largest, std::abs(entry));
    const auto at = [&](std::size_t i, std::size_t j) {
        return (i == j ? bound - m[bendIndex(i, j)] : -m[bendIndex(i, j)]) / largest;
    };
    constexpr double rounding = 1e-14;  // of sums of products of up to three numbers below 2
    const double first = at(0, 0), second = at(0, 0) * at(1, 1) - at(0, 1) * at(0, 1);
    const double third = at(0, 0) * (at(1, 1) * at(2, 2) - at(1, 2) * at(1, 2)) -
                         at(0, 1) * (at(0, 1) * at(2, 2) - at(1, 2) * at(0, 2)) +
                         at(0, 2) * (at(0, 1) * at(1, 2) - at(1, 1) * at(0, 2));
    return first > rounding && second > rounding && third > rounding;
}

}  // namespace

double eigenvalueAbove(const std::array<SlopeRange, 6>& m) {
    double trace = 0, widest = 0, spread = 0;
    SymmetricMatrix middle;
    std::array<double, 6> reach;
    for (std::size_t k = 0; k < 6; ++k) {
        middle[k] = 0.5 * m[k].low + 0.5 * m[k].high;
        reach[k] = std::max(raised(m[k].high - middle[k]), raised(middle[k] - m[k].low));
    }
    for (std::size_t i = 0; i < 3; ++i) {
        double row = m[bendIndex(i, i)].high, besides = reach[bendIndex(i, i)];
        trace = raised(trace + row);
        for (std::size_t j = 0; j < 3; ++j) {
            if (j == i) continue;
            row = raised(row + m[bendIndex(i, j)].size());
            besides = raised(besides + reach[bendIndex(i, j)]);
        }
        widest = std::max(widest, row);
        spread = std::max(spread, besides);
    }
    const double bound = std::min(trace, widest);
    // Rows of matrices with large entries beside the diagonal say too much.
    constexpr double slack = 1e-5;
    const double least =
        std::max({middle[bendIndex(0, 0)], middle[bendIndex(1, 1)], middle[bendIndex(2, 2)]});
    if (bound <= least * (1 + slack)) return bound;
    const double near = eigenvalueNear(middle) * (1 + slack), closer = raised(near + spread);
    return closer < bound && isAboveEigenvalues(middle, near) ? closer : bound;
}

void settle(IntervalGradient& a) {
    bool finite = true;
    for (const SlopeRange& range : a.slope) finite = finite && range.isFinite();
    if (finite && std::has_single_bit(a.axes))
        a.steepness =
            std::min(a.steepness, a.slope[static_cast<std::size_t>(std::countr_zero(a.axes))].size());
    else if (finite)
        a.steepness = std::min(a.steepness, lengthAbove(a.slope));
    if (!finite || !(a.steepness < unlimited)) {
        a = hazardous(resolveWrap(a).value, a.axes, worse(a.hazard, GradientHazard::overflow));
        return;
    }
    for (SlopeRange& range : a.slope) range = meet(range, SlopeRange::within(a.steepness));
    for (const SlopeRange& range : a.bend) a.smooth = a.smooth && range.isFinite();
}

IntervalGradient afterWrap(const IntervalGradient& a) {
    // Wraps are rounded, by every factor.
    const double least = a.wrap * (1 - 1e-14), most = a.wrap * (1 + 1e-14);
    IntervalGradient result = a;
    result.value = a.value - Interval{std::min(least, most), std::max(least, most), false};
    result.wrap = 0;
    result.rootExponent = 0;
    result.sumsExponentials = false;
    result.origin = 0;
    return result;
}

bool cutsAroundZero(const IntervalGradient& a) {
    return std::abs(a.cutAt - a.wrap / 2) <= 1e-14 * std::abs(a.wrap);
}

IntervalGradient resolveWrap(const IntervalGradient& a) {
    IntervalGradient result = a;
    if (a.wrap == 0) return result;
    result.value = hull(a.value, afterWrap(a).value);
    result.wrap = 0;
    result.hazard = worse(a.hazard, GradientHazard::jump);
    result.smooth = false;
    return result;
}

// Results are large. A function with one result of its own, returned everywhere, makes it where the caller
// wants it, without a copy; so those with other ends leave making it to another one.
namespace {

/// chain() where nothing is wrong: the slopes of h are finite, and u has no hazard worse than a jump.
IntervalGradient chained(const IntervalGradient& u, const Interval& value, const Derivatives& h) {
    IntervalGradient result;
    result.value = value;
    result.axes = u.axes;
    result.hazard = u.hazard;
    for (std::size_t i = 0; i < 3; ++i)
        if (dependsOn(u.axes, i)) result.slope[i] = h.first * u.slope[i];
    result.steepness = raised(h.first.size() * u.steepness);
    // Other pieces have other values than the one that is taken.
    result.pieced = u.pieced;
    result.smooth = u.smooth && !u.pieced && h.second.isFinite();
    if (result.smooth)
        forEachBend(u.axes, [&](std::size_t i, std::size_t j, std::size_t k) {
            const SlopeRange slopes = i == j ? square(u.slope[i]) : u.slope[i] * u.slope[j];
            result.bend[k] = h.second * slopes + h.first * u.bend[k];
        });
    settle(result);
    return result;
}

IntervalGradient chained(const IntervalGradient& u, const IntervalGradient& v, const Interval& value,
                         const TwoDerivatives& h) {
    const std::uint8_t axes = u.axes | v.axes;
    IntervalGradient result;
    result.value = value;
    result.axes = axes;
    result.hazard = worse(u.hazard, v.hazard);
    std::array<SlopeRange, 3> first{}, second{};
    for (std::size_t i = 0; i < 3; ++i) {
        if (!dependsOn(axes, i)) continue;
        first[i] = h.byFirst * u.slope[i];
        second[i] = h.bySecond * v.slope[i];
        result.slope[i] = first[i] + second[i];
    }
    result.steepness = lengthOfSum(first, raised(h.byFirst.size() * u.steepness), second,
                                   raised(h.bySecond.size() * v.steepness), u.axes & v.axes);
    result.pieced = u.pieced || v.pieced;
    result.smooth = u.smooth && v.smooth && !u.pieced && !v.pieced && h.twiceFirst.isFinite() &&
                    h.mixed.isFinite() && h.twiceSecond.isFinite();
    if (result.smooth)
        forEachBend(axes, [&](std::size_t i, std::size_t j, std::size_t k) {
            const SlopeRange crossed = u.slope[i] * v.slope[j] + v.slope[i] * u.slope[j];
            result.bend[k] = h.twiceFirst * (u.slope[i] * u.slope[j]) + h.mixed * crossed +
                             h.twiceSecond * (v.slope[i] * v.slope[j]) + h.byFirst * u.bend[k] +
                             h.bySecond * v.bend[k];
        });
    settle(result);
    return result;
}

}  // namespace

IntervalGradient chain(const IntervalGradient& u, const Interval& value, const Derivatives& h,
                       GradientHazard hazard) {
    if (u.isConstant()) return constant(value);
    if (value.empty()) return undefinedEverywhere();
    if (u.hazard > GradientHazard::jump) return hazardous(value, u.axes, u.hazard);
    if (!h.first.isFinite()) return hazardous(value, u.axes, worse(u.hazard, hazard));
    return chained(u, value, h);
}

IntervalGradient chain(const IntervalGradient& u, const IntervalGradient& v, const Interval& value,
                       const TwoDerivatives& h, GradientHazard hazard) {
    if (value.empty()) return undefinedEverywhere();
    const std::uint8_t axes = u.axes | v.axes;
    const GradientHazard both = worse(u.hazard, v.hazard);
    if (both > GradientHazard::jump) return hazardous(value, axes, both);
    if (!h.byFirst.isFinite() || !h.bySecond.isFinite()) return hazardous(value, axes, worse(both, hazard));
    return chained(u, v, value, h);
}

/// factor a, which has the value `value`.
static IntervalGradient scaledTo(const Interval& value, const IntervalGradient& a, double factor) {
    IntervalGradient result = a;
    result.value = value;
    if (std::abs(factor) != 1) result.angleSteepness = 0;
    if (factor < 0) result.origin = -a.origin;
    result.wrap = a.wrap * factor;
    result.cutAt = a.cutAt * factor;
    if (a.hazard > GradientHazard::jump) return result;
    for (std::size_t i = 0; i < 3; ++i)
        if (dependsOn(a.axes, i)) result.slope[i] = factor * a.slope[i];
    result.steepness = raised(std::abs(factor) * a.steepness);
    if (a.smooth)
        forEachBend(a.axes,
                    [&](std::size_t, std::size_t, std::size_t k) { result.bend[k] = factor * a.bend[k]; });
    result.rootExponent = factor > 0 ? a.rootExponent : 0;
    result.sumsExponentials = factor > 0 && a.sumsExponentials;
    result.root.known = result.root.known && (result.isSumOfPowers() || result.sumsExponentials);
    if (result.sumsExponentials) result.root = movedRoot(a.root, 1, log(Interval::point(factor)));
    if (result.isSumOfPowers()) {
        result.root = scaledRoot(a.root, Interval::point(factor), a.rootExponent);
        result.rootSteepness = raised(std::pow(factor, 1 / a.rootExponent) * (1 + 1e-14) * a.rootSteepness);
        forEachBend(a.axes, [&](std::size_t, std::size_t, std::size_t k) {
            result.rootSpread[k] = factor * a.rootSpread[k];
        });
    }
    settle(result);
    return result;
}

IntervalGradient scaled(const IntervalGradient& a, double factor) {
    if (!std::isfinite(factor))
        return hazardous(resolveWrap(a).value * Interval::point(factor), a.axes, GradientHazard::overflow);
    // A change of sign is exact.
    const Interval value = factor == 1    ? a.value
                           : factor == -1 ? -a.value
                                          : a.value * Interval::point(factor);
    if (value.empty()) return undefinedEverywhere();
    // Nothing is left of a singularity, unless 0 times infinity is undefined.
    if (factor == 0 && rangeOf(a.value).isFinite() && !a.value.maybeUndefined)
        return constant(Interval::point(0));
    return scaledTo(value, a, factor);
}

namespace {

/// Whether `wave` is a sine or cosine and `lift` a constant that keeps their sum from being negative.
bool isWaveAboveZero(const IntervalGradient& lift, const IntervalGradient& wave) {
    return lift.isConstant() && lift.value.low >= 1 && wave.angleSteepness > 0;
}

/// a + shift: the slopes stay.
IntervalGradient moved(const IntervalGradient& a, const Interval& shift) {
    IntervalGradient result = a;
    result.value = a.value + shift;
    if (result.value.empty()) {
        result = undefinedEverywhere();
        return result;
    }
    result.origin = 0;
    result.angleSteepness = 0;
    result.rootExponent = 0;
    result.sumsExponentials = false;
    if (a.wrap != 0)
        result.cutAt = shift.isPoint() ? a.cutAt + shift.low : std::numeric_limits<double>::quiet_NaN();
    return result;
}

}  // namespace

/// a + b, which has the value `value`, without a hazard worse than a jump; where both are sums of powers, of
/// the same exponent.
static IntervalGradient summed(const Interval& value, const IntervalGradient& a, const IntervalGradient& b) {
    IntervalGradient result;
    result.value = value;
    result.axes = a.axes | b.axes;
    result.hazard = worse(a.hazard, b.hazard);
    result.wrap = a.wrap + b.wrap;
    if (result.wrap != 0) {
        const IntervalGradient& other = a.wrap != 0 ? b : a;
        if (other.value.isPoint()) result.cutAt = (a.wrap != 0 ? a : b).cutAt + other.value.low;
    }
    for (std::size_t i = 0; i < 3; ++i)
        if (dependsOn(result.axes, i)) result.slope[i] = a.slope[i] + b.slope[i];
    result.steepness = lengthOfSum(a.slope, a.steepness, b.slope, b.steepness, a.axes & b.axes);
    result.smooth = a.smooth && b.smooth;
    result.pieced = a.pieced || b.pieced;
    if (result.smooth)
        forEachBend(result.axes,
                    [&](std::size_t, std::size_t, std::size_t k) { result.bend[k] = a.bend[k] + b.bend[k]; });
    const auto isPositive = [](const IntervalGradient& part) {
        return part.sumsExponentials || (part.isConstant() && part.value.low > 0);
    };
    if ((a.sumsExponentials || b.sumsExponentials) && isPositive(a) && isPositive(b)) {
        const auto logarithm = [](const IntervalGradient& part) {
            return part.sumsExponentials ? part.root : constantLogarithm(part.value);
        };
        result.root = joinedLogarithm(logarithm(a), logarithm(b), result.axes);
        result.sumsExponentials = result.root.known;
        result.rootSteepness =
            std::max(a.isConstant() ? 0 : a.rootSteepness, b.isConstant() ? 0 : b.rootSteepness);
    } else if (a.isSumOfPowers() && b.isSumOfPowers() && sameExponent(a.rootExponent, b.rootExponent)) {
        addRoots(a, b, result);
        if (a.rootExponent == b.rootExponent)
            result.root = joinedRoot(a.root, b.root, a.rootExponent, result.axes);
    } else if ((a.isSumOfPowers() && b.isConstant() && b.value.low >= 0) ||
               (b.isSumOfPowers() && a.isConstant() && a.value.low >= 0)) {
        // A positive constant only flattens the root.
        const bool first = a.isSumOfPowers();
        const IntervalGradient& powers = first ? a : b;
        if (powers.root.known)
            result.root = joinedRoot(powers.root, constantRoot((first ? b : a).value, powers.rootExponent),
                                     powers.rootExponent, result.axes);
        result.rootExponent = powers.rootExponent;
        result.rootSteepness = powers.rootSteepness;
        result.rootSpread = powers.rootSpread;
    } else if (isWaveAboveZero(a, b) || isWaveAboveZero(b, a)) {
        // 1 + sin u = 2 sin^2(u/2 + pi/4), and a greater constant only flattens the root of that.
        result.value.low = std::max(0.0, result.value.low);
        result.rootExponent = 2;
        result.rootSteepness =
            raised(std::numbers::sqrt2 / 2 * (1 + 1e-15) * std::max(a.angleSteepness, b.angleSteepness));
        result.rootSpread = spreadWithin(result.rootSteepness);
    }
    settle(result);
    return result;
}

IntervalGradient sum(const IntervalGradient& a, const IntervalGradient& b) {
    const bool keepsPowers = a.isSumOfPowers() || b.isSumOfPowers() || a.angleSteepness > 0 ||
                             b.angleSteepness > 0 || a.sumsExponentials || b.sumsExponentials;
    if (b.isConstant() && !keepsPowers && a.bounded()) return moved(a, b.value);
    if (a.isConstant() && !keepsPowers && b.bounded()) return moved(b, a.value);
    // Two cuts may lie at different places.
    if (a.wrap != 0 && b.wrap != 0) return sum(resolveWrap(a), resolveWrap(b));
    if (a.isSumOfPowers() && b.isSumOfPowers() && !sameExponent(a.rootExponent, b.rootExponent))
        return a.rootExponent > b.rootExponent ? sum(withRootExponent(a, b.rootExponent), b)
                                               : sum(a, withRootExponent(b, a.rootExponent));
    const GradientHazard both = worse(a.hazard, b.hazard);
    // Of what has no bounds a pending wrap is not kept.
    if (both > GradientHazard::jump && (a.wrap != 0 || b.wrap != 0))
        return sum(resolveWrap(a), resolveWrap(b));
    const Interval value = a.value + b.value;
    if (value.empty()) return undefinedEverywhere();
    if (both > GradientHazard::jump) return hazardous(value, a.axes | b.axes, both);
    return summed(value, a, b);
}

namespace {

/// a b, where each is a positive multiple of the same value: the square of their geometric mean.
void makeSquare(const IntervalGradient& a, const IntervalGradient& b, IntervalGradient& result) {
    result.value.low = std::max(0.0, result.value.low);
    result.rootExponent = 2;
    result.rootSteepness = rootAbove(raised(a.steepness * b.steepness));
    const std::size_t axis = static_cast<std::size_t>(std::abs(a.origin)) - 1;
    if (a.value == b.value && a.slope[axis].low == b.slope[axis].low &&
        a.slope[axis].high == b.slope[axis].high)
        result.root = rootOf(a);
    forEachBend(result.axes, [&](std::size_t i, std::size_t j, std::size_t k) {
        // Parts of one gradient, up to a factor: on the diagonal they have the same sign.
        result.rootSpread[k] = a.slope[i] * b.slope[j];
        if (i == j) result.rootSpread[k].low = std::max(0.0, result.rootSpread[k].low);
    });
}

}  // namespace

IntervalGradient product(const IntervalGradient& a, const IntervalGradient& b) {
    if (a.isConstant() && a.value.isPoint()) return scaled(b, a.value.low);
    if (b.isConstant() && b.value.isPoint()) return scaled(a, b.value.low);
    if (a.wrap != 0 || b.wrap != 0) return product(resolveWrap(a), resolveWrap(b));
    const SlopeRange zero{}, one{1, 1};
    IntervalGradient result =
        chain(a, b, a.value * b.value, {rangeOf(b.value), rangeOf(a.value), zero, one, zero},
              GradientHazard::overflow);
    if (a.origin != 0 && a.origin == b.origin && result.hazard <= GradientHazard::jump &&
        !result.isConstant())
        makeSquare(a, b, result);
    return result;
}

/// either() without a hazard worse than a jump.
static IntervalGradient joined(const IntervalGradient& a, const IntervalGradient& b, const Interval& value) {
    IntervalGradient result;
    result.value = value;
    result.axes = a.axes | b.axes;
    result.hazard = worse(a.hazard, b.hazard);
    for (std::size_t i = 0; i < 3; ++i) result.slope[i] = hull(a.slope[i], b.slope[i]);
    result.steepness = std::max(a.steepness, b.steepness);
    result.pieced = result.axes != 0;
    result.smooth = a.smooth && b.smooth;
    if (result.smooth)
        forEachBend(result.axes, [&](std::size_t, std::size_t, std::size_t k) {
            result.bend[k] = hull(a.bend[k], b.bend[k]);
        });
    if (a.angleSteepness > 0 && b.angleSteepness > 0)
        result.angleSteepness = std::max(a.angleSteepness, b.angleSteepness);
    if (a.isSumOfPowers() && a.rootExponent == b.rootExponent) {
        result.rootExponent = a.rootExponent;
        result.rootSteepness = std::max(a.rootSteepness, b.rootSteepness);
        for (std::size_t k = 0; k < 6; ++k) result.rootSpread[k] = hull(a.rootSpread[k], b.rootSpread[k]);
    }
    settle(result);
    return result;
}

IntervalGradient either(const IntervalGradient& a, const IntervalGradient& b, const Interval& value) {
    const GradientHazard both = worse(a.hazard, b.hazard);
    if (both > GradientHazard::jump) return hazardous(value, a.axes | b.axes, both);
    return joined(a, b, value);
}

}  // namespace isoscope::gradient_rules
