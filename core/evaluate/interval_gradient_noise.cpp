// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "core/evaluate/interval_gradient_rules.h"
#include "core/numeric/noise.h"
#include "core/numeric/noise_bounds.h"
#include "core/numeric/noise_gradient.h"

namespace isoscope::gradient_rules {

namespace {

/// A function of three values with slopes in `slope`, and none of them together longer than `steepness`.
IntervalGradient ofThree(Operands places, const Interval& value, const std::array<SlopeRange, 3>& slope,
                         double steepness) {
    IntervalGradient result;
    result.value = value;
    result.smooth = false;
    std::array<SlopeRange, 6> spread{};
    for (const IntervalGradient* p : places) {
        result.axes |= p->axes;
        result.hazard = worse(result.hazard, p->hazard);
    }
    if (result.hazard > GradientHazard::jump) return hazardous(value, result.axes, result.hazard);
    double steepestPlace = 0;
    bool perpendicular = true;
    std::uint8_t seen = 0;
    for (int k = 0; k < 3; ++k) {
        const IntervalGradient& p = *places[k];
        perpendicular = perpendicular && (seen & p.axes) == 0;
        seen |= p.axes;
        steepestPlace = std::max(steepestPlace, p.steepness);
        for (int i = 0; i < 3; ++i) {
            result.slope[i] = result.slope[i] + slope[k] * p.slope[i];
            for (int j = i; j < 3; ++j)
                spread[bendIndex(i, j)] = spread[bendIndex(i, j)] + p.slope[i] * p.slope[j];
        }
    }
    const double stretch = perpendicular ? steepestPlace : rootAbove(eigenvalueAbove(spread));
    result.steepness = raised(steepness * stretch);
    settle(result);
    return result;
}

struct NoiseRange {
    Interval value;
    std::array<SlopeRange, 3> slope;
    double steepness;
};

/// Around a place whose value and gradient are known, for boxes with these half widths.
NoiseRange around(const NoiseGradient& center, const std::array<double, 3>& radius, const NoiseBounds& bounds) {
    // More than what rounding changes.
    constexpr double slack = 1e-11;
    double reach = 0, length = 0, total = 0;
    for (int k = 0; k < 3; ++k) {
        reach += radius[k] * radius[k];
        length += center.gradient[k] * center.gradient[k];
        total += radius[k];
    }
    reach = std::sqrt(reach) * (1 + 1e-12);
    NoiseRange range;
    const double rise = bounds.lipschitz * reach + slack;
    range.value = {std::max(bounds.low, center.value - rise), std::min(bounds.high, center.value + rise), false};
    for (int k = 0; k < 3; ++k) {
        const double change = (bounds.bend * radius[k] + bounds.twist * (total - radius[k])) * (1 + 1e-12) + slack;
        range.slope[k] = meet({center.gradient[k] - change, center.gradient[k] + change},
                              SlopeRange::within(bounds.slope));
    }
    range.steepness = std::min(bounds.lipschitz, (std::sqrt(length) + bounds.curvature * reach) * (1 + 1e-12) + slack);
    return range;
}

/// Centre and half widths of the places; false when they reach beyond the lattice.
bool centerOf(Operands places, std::array<double, 3>& center, std::array<double, 3>& radius) {
    constexpr double limit = 2147483647.0;
    for (int k = 0; k < 3; ++k) {
        const Interval& p = places[k]->value;
        if (p.empty() || p.maybeUndefined || !(p.low > -limit && p.high < limit)) return false;
        center[k] = 0.5 * p.low + 0.5 * p.high;
        radius[k] = raised(std::max(p.high - center[k], center[k] - p.low));
    }
    return true;
}

}  // namespace

IntervalGradient noiseOf(Operation operation, Operands operands) {
    const bool scalar = operation == Operation::noise;
    const Operands places = operands.last(3);
    const Interval everywhere = scalar ? Interval{0, 1, false} : Interval{-vectorNoiseLimit, vectorNoiseLimit, false};
    std::uint8_t axes = 0;
    for (const IntervalGradient* operand : operands) axes |= operand->axes;
    std::array<double, 3> center{}, radius{};
    if (!centerOf(places, center, radius)) return hazardous(everywhere, axes, GradientHazard::unknown);
    if (!scalar) {
        const auto all = vectorNoiseWithGradient(center[0], center[1], center[2]);
        const int component = static_cast<int>(operation) - static_cast<int>(Operation::noiseGradientX);
        const NoiseRange range = around(all[component], radius, latticeNoiseBounds);
        return ofThree(places, range.value, range.slope, range.steepness);
    }
    if (!operands[0]->isConstant() || !operands[0]->value.isPoint())
        return hazardous(everywhere, axes, GradientHazard::unknown);
    const int generator = noiseGeneratorNumber(operands[0]->value.low);
    NoiseGradient raw = generator == 3 ? gradientNoiseWithGradient(center[0], center[1], center[2])
                                       : latticeNoiseWithGradient(center[0], center[1], center[2]);
    const double factor = generator == 3 ? 0.5 * 1.59 : generator == 2 ? 0.48985582 : 1;
    const double offset = generator == 3 ? 0.985 / 1.59 : generator == 2 ? 1.05242 : 0.5;
    raw.value = (raw.value + offset) * factor;
    for (double& slope : raw.gradient) slope *= factor;
    NoiseRange range = around(raw, radius, unclippedNoiseBounds(generator));
    if (range.value.low < 0 || range.value.high > 1)
        for (SlopeRange& slope : range.slope) slope = hull(slope, {});
    range.value = {std::clamp(range.value.low, 0.0, 1.0), std::clamp(range.value.high, 0.0, 1.0), false};
    return ofThree(places, range.value, range.slope, range.steepness);
}

IntervalGradient crackleOf(const CrackleSettings& settings, Operands places, const Interval& value) {
    std::uint8_t axes = 0;
    for (const IntervalGradient* place : places) axes |= place->axes;
    if (axes == 0) return constant(value);
    if (settings.cells || settings.solid) {
        IntervalGradient result = constant(value);
        result.axes = axes;
        result.hazard = GradientHazard::jump;
        result.smooth = false;
        return result;
    }
    // Each distance is a norm of the way to a cell point; a norm with exponent m >= 1 climbs by at most
    // 3^(1/m - 1/2), and never by more than 1 from 2 on.
    if (!(settings.metric >= 1)) return hazardous(value, axes, GradientHazard::unknown);
    const double climb = settings.metric >= 2 ? 1 : std::pow(3, 1 / settings.metric - 0.5) * (1 + 1e-12);
    double steepness = 0;
    for (const double form : settings.form) steepness += std::abs(form);
    steepness = raised(raised(steepness) * climb);
    return ofThree(places, value, {SlopeRange::within(steepness), SlopeRange::within(steepness), SlopeRange::within(steepness)},
                   steepness);
}

}  // namespace isoscope::gradient_rules
