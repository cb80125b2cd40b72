// SPDX-License-Identifier: GPL-3.0-or-later
// The roots of sums of powers: norms, whose derivatives are bounded without those of the sums. So are those
// of logarithms of sums of exponentials.
#include <algorithm>
#include <cmath>

#include "core/evaluate/algebra/interval_gradient_rules.h"

namespace isoscope::gradient_rules {

namespace {

/// Above the relative error of the power functions, of rounded exponents and of what is done with them here.
constexpr double powerRounding = 1e-13;

double powerAbove(double a, double e) {
    if (e == 1) return a;
    return e == 0 ? 1 : raised(std::pow(a, e) * (1 + powerRounding));
}
double powerBelow(double a, double e) {
    if (e == 1) return a;
    return e == 0 ? 1 : std::max(0.0, lowered(std::pow(a, e) * (1 - powerRounding)));
}

/// (a^e + b^e)^(1/e) for a, b >= 0.
double norm(double a, double b, double e) {
    if (e == 2) return std::sqrt(a * a + b * b);
    const double most = std::max(a, b), least = std::min(a, b);
    if (!(least > 0)) return most;
    return e == 1 ? a + b : most * std::pow(1 + std::pow(least / most, e), 1 / e);
}
double normAbove(double a, double b, double e) { return raised(norm(a, b, e) * (1 + powerRounding)); }
double normBelow(double a, double b, double e) {
    return std::max(0.0, lowered(norm(a, b, e) * (1 - powerRounding)));
}

/// The range of u / norm(u, v) for u in `u` and |v| in [least, most].
SlopeRange shareOf(const SlopeRange& u, double least, double most, double e) {
    const auto above = [&](double size) { return std::min(1.0, raised(size / normBelow(size, least, e))); };
    const auto below = [&](double size) { return std::max(0.0, lowered(size / normAbove(size, most, e))); };
    const auto upper = [&](double end) { return end > 0 ? above(end) : end < 0 ? -below(-end) : 0; };
    const auto lower = [&](double end) { return end > 0 ? below(end) : end < 0 ? -above(-end) : 0; };
    return {lower(u.low), upper(u.high)};
}

/// sign(t) |t|^e.
SlopeRange signedPower(const SlopeRange& t, double e) {
    const double low = t.low < 0 ? -powerAbove(-t.low, e) : powerBelow(t.low, e);
    const double high = t.high < 0 ? -powerBelow(-t.high, e) : powerAbove(t.high, e);
    return {low, high};
}

/// |t|^e, for any e.
SlopeRange sizePower(const SlopeRange& t, double e) {
    const double least = t.gap(), most = t.size();
    return e >= 0 ? SlopeRange{powerBelow(least, e), powerAbove(most, e)}
                  : SlopeRange{powerBelow(most, e), powerAbove(least, e)};
}

/// share a + (1 - share) b.
SlopeRange mixed(const SlopeRange& share, const SlopeRange& a, const SlopeRange& b) {
    const auto at = [&](double part) {
        return part * a + SlopeRange{lowered(1 - part), raised(1 - part)} * b;
    };
    return hull(at(share.low), at(share.high));
}

/// exp(a) / (exp(a) + exp(b)), by the difference a - b.
double shareAt(double difference) { return 1 / (1 + std::exp(-difference)); }

/// ln(exp(a) + exp(b)).
double logarithmOfSum(double a, double b) { return std::max(a, b) + std::log1p(std::exp(-std::abs(a - b))); }

}  // namespace

PowerRoot rootOf(const IntervalGradient& u) {
    PowerRoot root;
    root.value = rangeOf(u.value);
    root.known = root.value.isFinite() && u.hazard <= GradientHazard::jump;
    root.smooth = u.smooth && !u.pieced;
    root.slope = u.slope;
    root.steepness = u.steepness;
    if (root.smooth) root.bend = u.bend;
    return root;
}

PowerRoot constantRoot(const Interval& value, double exponent) {
    PowerRoot root;
    root.value = {powerBelow(std::max(0.0, value.low), 1 / exponent),
                  powerAbove(std::max(0.0, value.high), 1 / exponent)};
    root.known = root.value.isFinite();
    root.smooth = true;
    return root;
}

PowerRoot scaledRoot(const PowerRoot& root, const Interval& factor, double exponent) {
    if (!root.known) return {};
    const SlopeRange stretch{powerBelow(factor.low, 1 / exponent), powerAbove(factor.high, 1 / exponent)};
    PowerRoot result = root;
    result.value = stretch * root.value;
    result.known = result.value.isFinite();
    for (SlopeRange& slope : result.slope) slope = stretch * slope;
    result.steepness = raised(stretch.high * root.steepness);
    for (SlopeRange& bend : result.bend) bend = stretch * bend;
    return result;
}

PowerRoot joinedRoot(const PowerRoot& a, const PowerRoot& b, double e, std::uint8_t axes) {
    PowerRoot result;
    if (!a.known || !b.known) return result;
    const double least = normBelow(a.value.gap(), b.value.gap(), e);
    result.value = {least, normAbove(a.value.size(), b.value.size(), e)};
    if (!result.value.isFinite()) return result;
    result.known = true;
    // By the two roots the norm has the derivatives of a share to the power e - 1.
    const SlopeRange first = shareOf(a.value, b.value.gap(), b.value.size(), e);
    const SlopeRange second = shareOf(b.value, a.value.gap(), a.value.size(), e);
    const SlopeRange byFirst = signedPower(first, e - 1), bySecond = signedPower(second, e - 1);
    for (std::size_t i = 0; i < 3; ++i)
        if (dependsOn(axes, i)) result.slope[i] = byFirst * a.slope[i] + bySecond * b.slope[i];
    // Where one is far smaller than the other its direction does not matter.
    result.steepness = raised(raised(byFirst.size() * a.steepness) + raised(bySecond.size() * b.steepness));
    if (!a.smooth || !b.smooth || !(least > 0)) return result;
    // Across the direction of growth it bends by (e - 1) / norm |first second|^(e - 2).
    const double most = powerAbove(1 / least, 1) * (1 + powerRounding);
    const SlopeRange factor =
        (e - 1) * (sizePower(first, e - 2) * sizePower(second, e - 2) *
                   SlopeRange{std::max(0.0, lowered(1 / result.value.high)), raised(most)});
    if (!factor.isFinite()) return result;
    result.smooth = true;
    std::array<SlopeRange, 3> across{};
    for (std::size_t i = 0; i < 3; ++i)
        if (dependsOn(axes, i)) across[i] = second * a.slope[i] - first * b.slope[i];
    forEachBend(axes, [&](std::size_t i, std::size_t j, std::size_t k) {
        const SlopeRange bent = i == j ? square(across[i]) : across[i] * across[j];
        result.bend[k] = factor * bent + byFirst * a.bend[k] + bySecond * b.bend[k];
    });
    return result;
}

PowerRoot poweredRoot(const PowerRoot& root, double e, std::uint8_t axes) {
    PowerRoot result;
    const SlopeRange first = e * signedPower(root.value, e - 1);
    const SlopeRange second = (e * (e - 1)) * sizePower(root.value, e - 2);
    result.value = sizePower(root.value, e);
    result.known = root.known && result.value.isFinite() && first.isFinite();
    if (!result.known) return result;
    for (std::size_t i = 0; i < 3; ++i) result.slope[i] = first * root.slope[i];
    result.steepness = raised(first.size() * root.steepness);
    result.smooth = root.smooth && second.isFinite();
    if (!result.smooth) return result;
    forEachBend(axes, [&](std::size_t i, std::size_t j, std::size_t k) {
        const SlopeRange slopes = i == j ? square(root.slope[i]) : root.slope[i] * root.slope[j];
        result.bend[k] = second * slopes + first * root.bend[k];
    });
    return result;
}

PowerRoot constantLogarithm(const Interval& value) {
    PowerRoot root;
    const Interval logarithm = log(value);
    root.value = {logarithm.low, logarithm.high};
    root.known = value.low > 0 && root.value.isFinite();
    root.smooth = true;
    return root;
}

PowerRoot movedRoot(const PowerRoot& root, double factor, const Interval& shift) {
    PowerRoot result = root;
    result.value = factor * root.value + SlopeRange{shift.low, shift.high};
    result.known = root.known && result.value.isFinite();
    for (SlopeRange& slope : result.slope) slope = factor * slope;
    result.steepness = raised(std::abs(factor) * root.steepness);
    for (SlopeRange& bend : result.bend) bend = factor * bend;
    return result;
}

PowerRoot joinedLogarithm(const PowerRoot& a, const PowerRoot& b, std::uint8_t axes) {
    PowerRoot result;
    if (!a.known || !b.known) return result;
    const double low = logarithmOfSum(a.value.low, b.value.low),
                 high = logarithmOfSum(a.value.high, b.value.high);
    const double slack = powerRounding * (1 + std::abs(low) + std::abs(high));
    result.value = {low - slack, high + slack};
    result.known = result.value.isFinite();
    if (!result.known) return result;
    const double least = a.value.low - b.value.high, most = a.value.high - b.value.low;
    const double rounding = powerRounding * (1 + std::abs(least) + std::abs(most));
    const SlopeRange share{std::max(0.0, lowered(shareAt(least - rounding) * (1 - powerRounding))),
                           std::min(1.0, raised(shareAt(most + rounding) * (1 + powerRounding)))};
    for (std::size_t i = 0; i < 3; ++i)
        if (dependsOn(axes, i)) result.slope[i] = mixed(share, a.slope[i], b.slope[i]);
    result.steepness = mixed(share, {0, a.steepness}, {0, b.steepness}).high;
    result.smooth = a.smooth && b.smooth;
    if (!result.smooth) return result;
    // share (1 - share), which is 1/4 at most.
    const double nearest = std::clamp(0.5, share.low, share.high);
    const auto spread = [](double part) { return part * (1 - part); };
    const SlopeRange both{std::max(0.0, lowered(lowered(std::min(spread(share.low), spread(share.high))))),
                          raised(raised(spread(nearest)))};
    std::array<SlopeRange, 3> across{};
    for (std::size_t i = 0; i < 3; ++i) across[i] = a.slope[i] - b.slope[i];
    forEachBend(axes, [&](std::size_t i, std::size_t j, std::size_t k) {
        const SlopeRange bent = i == j ? square(across[i]) : across[i] * across[j];
        result.bend[k] = mixed(share, a.bend[k], b.bend[k]) + both * bent;
    });
    return result;
}

namespace {

void narrow(SlopeRange& known, const SlopeRange& other) {
    const SlopeRange both = meet(known, other);
    if (both.low <= both.high) known = both;
}

}  // namespace

void useLogarithm(const IntervalGradient& s, IntervalGradient& result) {
    if (!s.sumsExponentials || !s.root.known || !result.bounded() || result.isConstant()) return;
    for (std::size_t i = 0; i < 3; ++i) narrow(result.slope[i], s.root.slope[i]);
    result.steepness = std::min({result.steepness, s.rootSteepness, s.root.steepness});
    if (s.root.smooth && result.smooth)
        for (std::size_t k = 0; k < 6; ++k) narrow(result.bend[k], s.root.bend[k]);
    settle(result);
}

void useExponential(const PowerRoot& root, double steepness, IntervalGradient& result) {
    if (!root.known || !result.bounded() || result.isConstant()) return;
    result.rootExponent = 0;
    result.sumsExponentials = true;
    result.root = root;
    result.rootSteepness = std::min(steepness, root.steepness);
    const SlopeRange value = rangeOf(result.value);
    for (std::size_t i = 0; i < 3; ++i) narrow(result.slope[i], value * root.slope[i]);
    result.steepness = std::min(result.steepness, raised(value.size() * result.rootSteepness));
    if (root.smooth && result.smooth)
        forEachBend(result.axes, [&](std::size_t i, std::size_t j, std::size_t k) {
            const SlopeRange slopes = i == j ? square(root.slope[i]) : root.slope[i] * root.slope[j];
            narrow(result.bend[k], value * (slopes + root.bend[k]));
        });
    settle(result);
}

void usePowerOfRoot(const PowerRoot& root, double exponent, IntervalGradient& result) {
    if (!root.known || result.hazard > GradientHazard::jump) return;
    SlopeRange first, second;
    bool smooth = root.smooth;
    if (std::abs(exponent - 1) <= sameExponents) {
        first = {root.value.low < 0 ? -1.0 : 1.0, root.value.high > 0 ? 1.0 : -1.0};
        smooth = smooth && first.low == first.high;
        // What the difference can change: |value|^(10^-14) while doubles hold the value.
        if (exponent != 1) {
            first = first + SlopeRange::within(1e-11);
            second = SlopeRange::within(raised(1e-13 / root.value.gap()));
        }
    } else {
        first = exponent * signedPower(root.value, exponent - 1);
        second = (exponent * (exponent - 1)) * sizePower(root.value, exponent - 2);
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const SlopeRange both = meet(result.slope[i], first * root.slope[i]);
        if (both.low <= both.high) result.slope[i] = both;
    }
    if (first.isFinite())
        result.steepness = std::min(result.steepness, raised(first.size() * root.steepness));
    if (!smooth || !first.isFinite() || !second.isFinite()) return;
    const bool combines = result.smooth && !result.pieced;
    result.smooth = true;
    result.pieced = false;
    forEachBend(result.axes, [&](std::size_t i, std::size_t j, std::size_t k) {
        const SlopeRange slopes = i == j ? square(root.slope[i]) : root.slope[i] * root.slope[j];
        const SlopeRange bend = second * slopes + first * root.bend[k];
        const SlopeRange both = combines ? meet(result.bend[k], bend) : bend;
        result.bend[k] = both.low <= both.high ? both : bend;
    });
}

}  // namespace isoscope::gradient_rules
