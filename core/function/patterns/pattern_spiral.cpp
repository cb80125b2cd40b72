// SPDX-License-Identifier: GPL-3.0-or-later
// Patterns of the angle about an axis: radial, spiral1, spiral2.
#include <numbers>

#include "core/function/builtins/formula_blocks.h"
#include "core/function/patterns/pattern_call.h"

namespace isoscope {

namespace {

using std::numbers::pi;

Expression radial(const PatternCall& call) {
    const Expression angle = 0.25 + (atan2(call.x, call.z) + pi) / (2 * pi);
    return select(max(abs(call.x), abs(call.z)) - 0.001, call.number(0.25), angle);
}

Expression arms(const PatternCall& call, Expression radius) {
    // By the arcsine of y / radius, as the page has it, it would be badly conditioned beside the plane x = 0.
    const Expression angle = pi + atan2(-call.x, call.y);
    const Expression beta = select(radius, angle, call.number(0), angle);
    const Expression turned = call.z + radius + call.pattern.arms * beta / (2 * pi);
    const auto& amounts = call.pattern.turbulence;
    return amounts && (*amounts)[0] != 0 ? turned + (*amounts)[0] * turbulence(call) : turned;
}

}  // namespace

Expression spiralPattern(const PatternCall& call) {
    if (call.pattern.kind == PatternKind::radial) return radial(call);
    const Expression radius = length(call.x, call.y);
    const Expression winding = arms(call, radius);
    return call.pattern.kind == PatternKind::spiral1 ? winding : triangle(radius) + triangle(winding);
}

}  // namespace isoscope
