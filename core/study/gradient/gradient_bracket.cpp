// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/gradient/gradient_bracket.h"

#include <cmath>

namespace isoscope {

double GradientBracket::relativeWidth() const {
    if (!std::isfinite(upper)) return std::isfinite(lower) ? upper : 0;
    if (upper <= lower) return 0;
    return lower > 0 ? (upper - lower) / lower : std::numeric_limits<double>::infinity();
}

double GradientBeside::suggested() const { return upper > negligibleSlope ? roundValueAbove(upper) : 0; }

double roundValueAbove(double bound) {
    if (!(bound > 0) || !std::isfinite(bound) || bound > 1e300 || bound < 1e-300) return 0;
    const int exponent = static_cast<int>(std::floor(std::log10(bound))) - 1;
    // Whole powers of ten up to 10^22 are exact, so that the digits come out as they would be typed.
    const double scale = std::pow(10.0, std::abs(exponent));
    const double digits = exponent >= 0 ? bound / scale : bound * scale;
    const double rounded = std::ceil(digits * (1 - 1e-12));
    return exponent >= 0 ? rounded * scale : rounded / scale;
}

std::string_view name(GradientHazard hazard) {
    switch (hazard) {
        case GradientHazard::none: return "none";
        case GradientHazard::jump: return "jump";
        case GradientHazard::steepEdge: return "infinite-slope";
        case GradientHazard::pole: return "pole";
        case GradientHazard::overflow: return "overflow";
        case GradientHazard::unknown: return "unknown";
    }
    return "unknown";
}

std::string_view name(GradientState state) {
    switch (state) {
        case GradientState::running: return "running";
        case GradientState::tight: return "proven";
        case GradientState::unbounded: return "unbounded";
        case GradientState::unproven: return "unproven";
        case GradientState::stopped: return "stopped";
    }
    return "unproven";
}

std::string_view advice(GradientHazard hazard) {
    switch (hazard) {
        case GradientHazard::none: return "";
        case GradientHazard::jump:
            return "The value jumps here: replace floor, mod or select by something continuous, or keep the "
                   "jump "
                   "away from the surface by a smaller container.";
        case GradientHazard::steepEdge:
            return "The slope is infinite here: put a small constant under the root, as in "
                   "sqrt(x*x+z*z+1e-4), or "
                   "square both sides of the equation; else use a container without this place.";
        case GradientHazard::pole:
            return "The function has a pole or its slope is infinite here: multiply by the denominator, "
                   "clamp with "
                   "min and max, or use a container without this place.";
        case GradientHazard::overflow:
            return "The values are beyond the range of numbers here: use a smaller container or clamp with "
                   "min and "
                   "max.";
        case GradientHazard::unknown:
            return "No bound is known for this function: “evaluate” lets max_gradient follow what the rays "
                   "meet.";
    }
    return "";
}

}  // namespace isoscope
