// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/gradient/surface_verdict.h"

#include <cmath>

namespace isoscope {

std::optional<GradientVerdict> SurfaceVerdict::verdict() const {
    const GradientVerdict judged = judgeGradient(setting, bracket, effects ? effects->alongRays : 0);
    // A steeper place proves holes, and a bound that none exceeds, however far the proof has come. What is
    // right by now may turn out to be more than needed.
    const bool final = bracket.state != GradientState::running || judged == GradientVerdict::holes ||
                       judged == GradientVerdict::wasteful ||
                       (judged == GradientVerdict::right && setting <= wastefulFactor * bracket.lower);
    if (!final) return {};
    return judged;
}

std::optional<double> SurfaceVerdict::suggested() const {
    const double value = suggestedGradient(bracket);
    if (!(value > 0) || !std::isfinite(value)) return {};
    const bool running = bracket.state == GradientState::running;
    // A tighter bound would be rounded to the same.
    if (running && (bracket.seams || value != roundValueAbove(bracket.lower))) return {};
    return value;
}

bool SurfaceVerdict::mayLose() const {
    const auto known = verdict();
    return known == GradientVerdict::holes || known == GradientVerdict::unbounded ||
           known == GradientVerdict::unproven;
}

int badness(std::optional<GradientVerdict> verdict) {
    if (!verdict) return 1;
    switch (*verdict) {
        case GradientVerdict::right: return 0;
        case GradientVerdict::wasteful: return 2;
        case GradientVerdict::unproven: return 3;
        case GradientVerdict::unbounded: return 4;
        case GradientVerdict::holes: return 5;
    }
    return 3;
}

}  // namespace isoscope
