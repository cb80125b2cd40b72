// SPDX-License-Identifier: GPL-3.0-or-later
// Powers and roots, and the sums of powers that roots are taken of.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/evaluate/algebra/interval_gradient_rules.h"

namespace isoscope::gradient_rules {

namespace {

std::array<SlopeRange, 6> outerSquare(const IntervalGradient& u) {
    std::array<SlopeRange, 6> result{};
    forEachBend(u.axes, [&](std::size_t i, std::size_t j, std::size_t k) {
        result[k] = i == j ? square(u.slope[i]) : u.slope[i] * u.slope[j];
    });
    return result;
}

/// Longest gradient of the root of a sum of powers.
double rootSlopeAbove(const IntervalGradient& s) {
    if (s.rootExponent != 2) return s.rootSteepness;
    return std::min(s.rootSteepness, rootAbove(eigenvalueAbove(s.rootSpread)));
}

/// The same along one axis.
double rootSlopeAbove(const IntervalGradient& s, std::size_t axis) {
    const double all = rootSlopeAbove(s);
    return s.rootExponent != 2 ? all : std::min(all, rootAbove(s.rootSpread[bendIndex(axis, axis)].high));
}

}  // namespace

std::array<SlopeRange, 6> spreadWithin(double steepness) {
    const double most = raised(steepness * steepness);
    const SlopeRange diagonal{0, most}, beside = SlopeRange::within(most);
    return {diagonal, beside, beside, diagonal, beside, diagonal};
}

namespace {

/// At most so large is the product of both gradients, times the signs of the values, where it makes a norm of
/// both climb faster; infinite where that is not known.
double dotOf(const PowerRoot& a, const PowerRoot& b) {
    if (!a.known || !b.known) return std::numeric_limits<double>::infinity();
    SlopeRange dot;
    for (std::size_t i = 0; i < 3; ++i) dot = dot + a.slope[i] * b.slope[i];
    const auto hasSign = [](const PowerRoot& root) { return root.value.low >= 0 || root.value.high <= 0; };
    if (!hasSign(a) || !hasSign(b)) return dot.size();
    const bool alike = (a.value.low >= 0) == (b.value.low >= 0);
    return std::max(0.0, alike ? dot.high : -dot.low);
}

/// The longest v u + w t for v^2 + w^2 = 1, of vectors u and t that are no longer than these and whose
/// product times the sign of v w is no larger than `dot`: the root of the larger eigenvalue of their
/// products.
double spanAbove(double u, double t, double dot) {
    const double uu = raised(u * u), tt = raised(t * t), trace = raised(uu + tt);
    if (!(dot < raised(u * t))) return rootAbove(trace);
    const double half = raised(0.5 * std::abs(uu - tt));
    const double spread = rootAbove(raised(raised(half * half) + raised(dot * dot)));
    return rootAbove(std::min(trace, raised(raised(0.5 * trace) + spread)));
}

}  // namespace

IntervalGradient withRootExponent(const IntervalGradient& s, double exponent) {
    IntervalGradient result = s;
    const double e = s.rootExponent / exponent;
    const Interval root =
        pow(Interval{std::max(0.0, s.value.low), s.value.high, false}, Interval::point(1 / s.rootExponent));
    const double steepest = raised(e * pow(root, Interval::point(e - 1)).high) * (1 + 1e-13);
    result.rootSteepness = raised(steepest * s.rootSteepness);
    result.rootExponent = std::isfinite(result.rootSteepness) ? exponent : 0;
    result.root = poweredRoot(s.root, e, s.axes);
    result.rootSpread = spreadWithin(result.rootSteepness);
    if (!result.root.known) return result;
    forEachBend(s.axes, [&](std::size_t i, std::size_t j, std::size_t k) {
        const auto& slope = result.root.slope;
        result.rootSpread[k] = i == j ? square(slope[i]) : slope[i] * slope[j];
    });
    return result;
}

void addRoots(const IntervalGradient& s, const IntervalGradient& t, IntervalGradient& result) {
    // The root is a norm of the two roots; its derivatives w in them have the length 1 in the dual norm, with
    // the exponent e' = e / (e - 1). Their Euclidean length is at most 1 for e >= 2, else 2^(1/2 - 1/e').
    const double e = result.rootExponent = s.rootExponent;
    const double length = e >= 2 ? 1 : std::exp2(1 / e - 0.5) * (1 + 1e-14);
    const double a = s.rootSteepness, b = t.rootSteepness;
    // Gradients along different axes are perpendicular: the root climbs no faster than its steeper part.
    result.rootSteepness = (s.axes & t.axes) == 0 ? raised(length * std::max(a, b))
                                                  : raised(length * spanAbove(a, b, dotOf(s.root, t.root)));
    if (e != 2) return;
    const auto spread = t.rootExponent == 2 ? t.rootSpread : spreadWithin(t.rootSteepness);
    for (std::size_t k = 0; k < 6; ++k) result.rootSpread[k] = s.rootSpread[k] + spread[k];
}

IntervalGradient squareOf(const IntervalGradient& u) {
    const SlopeRange value = rangeOf(u.value), two{2, 2};
    IntervalGradient result = chain(u, square(u.value), {2.0 * value, two}, GradientHazard::overflow);
    // Beside a jump the root is no steeper than its slopes there.
    if (result.hazard > GradientHazard::jump || result.isConstant()) return result;
    result.rootExponent = 2;
    result.rootSteepness = u.steepness;
    result.rootSpread = outerSquare(u);
    result.root = u.rootExponent == 1 ? u.root : rootOf(u);
    if (u.pieced) {
        usePowerOfRoot(result.root, 2, result);
        settle(result);
    }
    return result;
}

namespace {

/// What is known of s^n for a sum of powers s, as the power of its root with the exponent e n >= 1.
void useRoot(const IntervalGradient& s, double n, IntervalGradient& result) {
    const double exponent = s.rootExponent * n;
    const Interval base{std::max(0.0, s.value.low), s.value.high, false};
    double steepest = 1;
    if (exponent > 1 + 1e-14) {
        const Interval rest =
            pow(pow(base, Interval::point(1 / s.rootExponent)), Interval::point(exponent - 1));
        steepest = raised(raised(rest.high) * exponent) * (1 + 1e-13);
    }
    result.steepness = std::min(result.steepness, raised(steepest * rootSlopeAbove(s)));
    for (std::size_t i = 0; i < 3; ++i)
        if (dependsOn(s.axes, i))
            result.slope[i] =
                meet(result.slope[i], SlopeRange::within(raised(steepest * rootSlopeAbove(s, i))));
    if (exponent >= 1) {
        result.rootExponent = exponent;
        result.rootSteepness = rootSlopeAbove(s);
        result.rootSpread = spreadWithin(result.rootSteepness);
        result.root = s.root;
    }
    usePowerOfRoot(s.root, exponent, result);
    settle(result);
}

/// s^n where its derivative in s is infinite.
IntervalGradient powerThroughRoot(const IntervalGradient& s, const Interval& value, double n) {
    IntervalGradient result;
    result.value = value;
    result.axes = s.axes;
    result.hazard = s.hazard;
    result.smooth = false;
    for (std::size_t i = 0; i < 3; ++i)
        if (dependsOn(s.axes, i)) result.slope[i] = SlopeRange::within(std::numeric_limits<double>::max());
    result.steepness = std::numeric_limits<double>::max();
    useRoot(s, n, result);
    return result;
}

/// The root of what is above 0; `usable`: is a sum of powers whose root is known.
IntervalGradient rootAboveZero(const IntervalGradient& u, const Interval& root, bool usable) {
    const Interval half = Interval::point(0.5), minusHalf = Interval::point(-0.5);
    const Interval first = half / root;
    IntervalGradient result =
        chain(u, root, {rangeOf(first), rangeOf(minusHalf * first / u.value)}, GradientHazard::steepEdge);
    if (usable && result.hazard <= GradientHazard::jump) useRoot(u, 0.5, result);
    return result;
}

}  // namespace

IntervalGradient squareRootOf(const IntervalGradient& u) {
    const Interval root = sqrt(u.value);
    if (u.isConstant()) return constant(root);
    if (root.empty()) return undefinedEverywhere();
    const bool usable = u.rootExponent >= 2 && u.hazard <= GradientHazard::jump;
    if (u.value.low > 0) return rootAboveZero(u, root, usable);
    if (usable) return powerThroughRoot(u, root, 0.5);
    return hazardous(root, u.axes, worse(u.hazard, GradientHazard::steepEdge));
}

namespace {

/// n-th powers for whole n >= 2.
IntervalGradient wholePowerOf(const IntervalGradient& u, double n) {
    const auto power = [&](double e) { return pow(u.value, Interval::point(e)); };
    const SlopeRange first = n * rangeOf(power(n - 1));
    IntervalGradient result =
        chain(u, power(n), {first, (n * (n - 1)) * rangeOf(power(n - 2))}, GradientHazard::overflow);
    if (!result.bounded() || result.isConstant()) return result;
    if (u.isSumOfPowers()) {
        useRoot(u, n, result);
    } else if (std::fmod(n, 2) == 0 || u.value.low >= 0) {
        result.rootExponent = n;
        result.rootSteepness = u.steepness;
        result.root = rootOf(u);
    }
    return result;
}

}  // namespace

namespace {

IntervalGradient powerOfAny(const IntervalGradient& u, double n) {
    if (n == 0) return constant(Interval::point(1));
    if (u.value.empty()) return undefinedEverywhere();
    if (n == 1) return u;
    if (n == 2) return squareOf(u);
    if (n == 0.5) return squareRootOf(u);
    const Interval value = pow(u.value, Interval::point(n));
    if (u.isConstant()) return constant(value);
    if (!std::isfinite(n)) return hazardous(value, u.axes, GradientHazard::unknown);
    const bool whole = std::floor(n) == n;
    if (whole && n > 2 && n <= 1e6) return wholePowerOf(u, n);
    if (value.empty()) return undefinedEverywhere();
    const auto power = [&](double e) { return pow(u.value, Interval::point(e)); };
    const bool usable = u.hazard <= GradientHazard::jump && n > 0 && u.rootExponent * n >= 1 - 1e-14;
    if (u.value.low > 0 || (whole && u.value.high < 0)) {
        const Interval first = Interval::point(n) * power(n - 1);
        const Interval second = Interval::point(n) * (Interval::point(n) - Interval::point(1)) * power(n - 2);
        IntervalGradient result =
            chain(u, value, {rangeOf(first), rangeOf(second)}, GradientHazard::overflow);
        if (result.bounded() && n >= 1 && !u.isSumOfPowers() && u.value.low > 0) {
            result.rootExponent = n;
            result.rootSteepness = u.steepness;
            result.root = rootOf(u);
        } else if (usable && result.bounded()) {
            useRoot(u, n, result);
        }
        return result;
    }
    if (n < 0) return hazardous(value, u.axes, worse(u.hazard, GradientHazard::pole));
    if (usable) return powerThroughRoot(u, value, n);
    if (!(n >= 1)) return hazardous(value, u.axes, worse(u.hazard, GradientHazard::steepEdge));
    const Interval base{std::max(0.0, u.value.low), u.value.high, false};
    const Interval first = Interval::point(n) * pow(base, Interval::point(n - 1));
    IntervalGradient result = chain(u, value, {rangeOf(first)}, GradientHazard::overflow);
    if (result.bounded() && u.value.low >= 0) {
        result.rootExponent = n;
        result.rootSteepness = u.steepness;
        result.root = rootOf(u);
        usePowerOfRoot(result.root, n, result);
        settle(result);
    }
    return result;
}

}  // namespace

IntervalGradient powerOf(const IntervalGradient& u, double n) {
    IntervalGradient result = powerOfAny(u, n);
    if (u.sumsExponentials && u.root.known && n != 0 && n != 1 && std::isfinite(n))
        useExponential(movedRoot(u.root, n, Interval::point(0)), raised(std::abs(n) * u.rootSteepness),
                       result);
    return result;
}

}  // namespace isoscope::gradient_rules
