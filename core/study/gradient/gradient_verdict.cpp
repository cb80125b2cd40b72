// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/gradient/gradient_verdict.h"

#include <cmath>

namespace isoscope {

namespace {

/// Numbers of the text and of the study are rounded: a setting equal to the bound is not too low.
constexpr double slack = 1 - 1e-9;

}  // namespace

GradientVerdict judgeGradient(double maxGradient, const GradientBracket& bracket, double alongRays) {
    const bool unbounded = bracket.state == GradientState::unbounded;
    const double steepest = unbounded ? alongRays : bracket.lower;
    if (maxGradient < steepest * slack) return GradientVerdict::holes;
    if (unbounded) return GradientVerdict::unbounded;
    if (!std::isfinite(bracket.upper) || bracket.seams) return GradientVerdict::unproven;
    // Between the ends of a loose bracket nothing steeper is known, and nothing excluded.
    if (bracket.state != GradientState::tight && maxGradient < bracket.upper * slack)
        return GradientVerdict::unproven;
    return maxGradient > wastefulFactor * bracket.upper ? GradientVerdict::wasteful : GradientVerdict::right;
}

std::string_view name(GradientVerdict verdict) {
    switch (verdict) {
        case GradientVerdict::holes: return "holes";
        case GradientVerdict::right: return "right";
        case GradientVerdict::wasteful: return "wasteful";
        case GradientVerdict::unbounded: return "unbounded";
        case GradientVerdict::unproven: return "unproven";
    }
    return "unproven";
}

double suggestedGradient(const GradientBracket& bracket) {
    if (!std::isfinite(bracket.upper)) return bracket.upper;
    return roundValueAbove(bracket.upper);
}

}  // namespace isoscope
