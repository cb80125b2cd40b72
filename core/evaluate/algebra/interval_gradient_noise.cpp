// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "core/evaluate/algebra/interval_gradient_rules.h"
#include "core/numeric/noise.h"
#include "core/numeric/noise_bounds.h"
#include "core/numeric/noise_range.h"

namespace isoscope::gradient_rules {

namespace {

/// The second derivatives of a function of three places with these derivatives.
void addBends(Operands places, const std::array<SlopeRange, 3>& slope, const std::array<SlopeRange, 6>& bend,
              IntervalGradient& result) {
    for (std::size_t k = 0; k < 3; ++k) {
        const IntervalGradient& p = *places[k];
        forEachBend(p.axes, [&](std::size_t, std::size_t, std::size_t at) {
            result.bend[at] = result.bend[at] + slope[k] * p.bend[at];
        });
        forEachBend(p.axes, [&](std::size_t i, std::size_t j, std::size_t at) {
            const SlopeRange product = i == j ? square(p.slope[i]) : p.slope[i] * p.slope[j];
            result.bend[at] = result.bend[at] + bend[bendIndex(k, k)] * product;
        });
        for (std::size_t l = k + 1; l < 3; ++l) {
            const IntervalGradient& q = *places[l];
            forEachBend(p.axes | q.axes, [&](std::size_t i, std::size_t j, std::size_t at) {
                const SlopeRange crossed = p.slope[i] * q.slope[j] + q.slope[i] * p.slope[j];
                result.bend[at] = result.bend[at] + bend[bendIndex(k, l)] * crossed;
            });
        }
    }
}

}  // namespace

IntervalGradient ofThree(Operands places, const Interval& value, const std::array<SlopeRange, 3>& slope,
                         double steepness, const std::array<SlopeRange, 6>* bend) {
    IntervalGradient result;
    result.value = value;
    result.smooth = bend != nullptr;
    std::array<SlopeRange, 6> spread{};
    for (const IntervalGradient* p : places) {
        result.axes |= p->axes;
        result.hazard = worse(result.hazard, p->hazard);
        // Other pieces have other places than the one that is taken.
        result.pieced = result.pieced || p->pieced;
        result.smooth = result.smooth && p->smooth && !p->pieced;
    }
    if (result.hazard > GradientHazard::jump) return hazardous(value, result.axes, result.hazard);
    double steepestPlace = 0;
    bool perpendicular = true;
    std::uint8_t seen = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const IntervalGradient& p = *places[k];
        perpendicular = perpendicular && (seen & p.axes) == 0;
        seen |= p.axes;
        steepestPlace = std::max(steepestPlace, p.steepness);
        for (std::size_t i = 0; i < 3; ++i) {
            result.slope[i] = result.slope[i] + slope[k] * p.slope[i];
            for (std::size_t j = i; j < 3; ++j)
                spread[bendIndex(i, j)] = spread[bendIndex(i, j)] + p.slope[i] * p.slope[j];
        }
    }
    if (result.smooth) addBends(places, slope, *bend, result);
    const double stretch = perpendicular ? steepestPlace : rootAbove(eigenvalueAbove(spread));
    result.steepness = raised(steepness * stretch);
    settle(result);
    return result;
}

namespace {

/// The places as a box; false when they reach beyond the lattice.
bool boxOf(Operands places, std::array<double, 3>& low, std::array<double, 3>& high) {
    constexpr double limit = 2147483646.0;
    for (std::size_t k = 0; k < 3; ++k) {
        const Interval& p = places[k]->value;
        if (p.empty() || p.maybeUndefined || !(p.low > -limit && p.high < limit)) return false;
        low[k] = p.low;
        high[k] = p.high;
    }
    return true;
}

/// Noise is its kind, shifted and stretched, then clipped to [0, 1].
struct Scaling {
    NoiseKind kind;
    double offset, factor;
};

Scaling scalingOf(int generator) {
    if (generator == 3) return {NoiseKind::gradient, 0.985 / 1.59, 0.5 * 1.59};
    if (generator == 2) return {NoiseKind::lattice0, 1.05242, 0.48985582};
    return {NoiseKind::lattice0, 0.5, 1};
}

}  // namespace

IntervalGradient noiseOf(Operation operation, Operands operands) {
    const bool scalar = operation == Operation::noise;
    const Operands places = operands.last(3);
    const Interval everywhere =
        scalar ? Interval{0, 1, false} : Interval{-vectorNoiseLimit, vectorNoiseLimit, false};
    std::uint8_t axes = 0;
    for (const IntervalGradient* operand : operands) axes |= operand->axes;
    std::array<double, 3> low{}, high{};
    if (!boxOf(places, low, high)) return hazardous(everywhere, axes, GradientHazard::unknown);
    if (!scalar) {
        const int component = noiseComponent(operation);
        const NoiseRange range = noiseRange(static_cast<NoiseKind>(component), low, high);
        return ofThree(places, {range.value.low, range.value.high, false}, range.slope, range.steepness,
                       &range.bend);
    }
    if (!operands[0]->isConstant() || !operands[0]->value.isPoint())
        return hazardous(everywhere, axes, GradientHazard::unknown);
    const Scaling scaling = scalingOf(noiseGeneratorNumber(operands[0]->value.low));
    NoiseRange range = noiseRange(scaling.kind, low, high);
    // The offset may be rounded otherwise than in the noise itself.
    const double bottom = lowered(lowered(range.value.low + scaling.offset) * scaling.factor) - noiseRounding;
    const double top = raised(raised(range.value.high + scaling.offset) * scaling.factor) + noiseRounding;
    const bool clipped = bottom < 0 || top > 1;
    for (SlopeRange& slope : range.slope) {
        slope = scaling.factor * slope;
        if (clipped) slope = hull(slope, {});
    }
    for (SlopeRange& bend : range.bend) bend = scaling.factor * bend;
    const double steepness = bottom > 1 || top < 0 ? 0 : raised(range.steepness * scaling.factor);
    const Interval value{std::clamp(bottom, 0.0, 1.0), std::clamp(top, 0.0, 1.0), false};
    return ofThree(places, value, range.slope, steepness, clipped ? nullptr : &range.bend);
}

}  // namespace isoscope::gradient_rules
