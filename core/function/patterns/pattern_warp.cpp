// SPDX-License-Identifier: GPL-3.0-or-later
// The warps have no formula in the specification; these were found by looking up coordinates through them in
// POV-Ray 3.7 and agree with it to its last digits.
#include "core/function/patterns/pattern_warp.h"

#include <cmath>
#include <numbers>

#include "core/function/builtins/formula_blocks.h"
#include "core/function/patterns/pattern_call.h"

namespace isoscope {

namespace {

using std::numbers::pi;

Expression fraction(Expression t) { return t - floor(t); }

PatternPoint warped(const TransformWarp& warp, const PatternPoint& p) {
    const auto& m = warp.inverse;
    PatternPoint result;
    for (std::size_t column = 0; column < 3; ++column)
        result[column] = p[0] * m[column] + p[1] * m[3 + column] + p[2] * m[6 + column] + m[9 + column];
    return result;
}

PatternPoint warped(const TurbulenceWarp& warp, const PatternPoint& p) {
    PatternPoint result = p;
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (warp.amount[axis] != 0)
            result[axis] = p[axis] + warp.amount[axis] *
                                         vectorTurbulence(p, axis, warp.octaves, warp.lambda, warp.omega);
    return result;
}

PatternPoint warped(const RepeatWarp& warp, const PatternPoint& p) {
    const double width = singlePrecision(warp.width);
    const auto across = static_cast<std::size_t>(warp.axis);
    const Expression number = floor(p[across] / width);
    PatternPoint result = p;
    result[across] = p[across] - number * width;
    const Expression isOdd = number - 2 * floor(number / 2);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (warp.flip[axis]) {
            const Expression mirrored = axis == across ? width - result[axis] : -result[axis];
            result[axis] = select(0.5 - isOdd, mirrored, result[axis]);
        }
        if (warp.offset[axis] != 0) result[axis] = result[axis] + number * warp.offset[axis];
    }
    return result;
}

PatternPoint warped(const BlackHoleWarp& warp, const PatternPoint& p) {
    PatternPoint away;
    for (std::size_t axis = 0; axis < 3; ++axis) away[axis] = p[axis] - warp.center[axis];
    const Expression distance = length(away[0], away[1], away[2]);
    const Expression depth = max(1 - distance / warp.radius, 0);
    const Expression pull = min(warp.strength * pow(depth, depth.number(warp.falloff)), 1);
    const Expression inside = select(distance - warp.radius, warp.inverse ? -pull : pull, pull.number(0));
    PatternPoint result;
    for (std::size_t axis = 0; axis < 3; ++axis) result[axis] = p[axis] + away[axis] * inside;
    return result;
}

/// (u, v) on the wrapped sheet and the distance from it, with the axis of the wrapping put in its place.
PatternPoint oriented(int orientation, Expression u, Expression v, Expression distance) {
    switch (orientation) {
        case 0: return {distance, v, -u};
        case 1: return {u, -distance, v};
        default: return {u, v, distance};
    }
}

PatternPoint warped(const PlanarWarp& warp, const PatternPoint& p) {
    return oriented(warp.orientation, p[0], p[1], p[0].number(warp.distance));
}

PatternPoint warped(const RoundWarp& warp, const PatternPoint& p) {
    const auto& [x, y, z] = p;
    const Expression around = length(x, z);
    Expression u = fraction(atan2(z, x) / (2 * pi));
    Expression v = y, distance = around;
    if (warp.kind == RoundWarp::Kind::spherical) {
        distance = length(x, y, z);
        v = 0.5 + apply(Operation::arcSine, y / distance) / pi;
    } else if (warp.kind == RoundWarp::Kind::toroidal) {
        const Expression across = around - warp.majorRadius;
        distance = length(across, y);
        v = 0.5 + atan2(y, across) / (2 * pi);
    }
    if (warp.distanceExponent != 0) {
        const Expression size = pow(distance, distance.number(warp.distanceExponent));
        u = u * size;
        if (warp.kind != RoundWarp::Kind::cylindrical) v = v * size;
    }
    return oriented(warp.orientation, u, v, distance);
}

}  // namespace

PatternPoint warpedPoint(const PatternWarp& warp, const PatternPoint& point) {
    return std::visit([&](const auto& kind) { return warped(kind, point); }, warp);
}

}  // namespace isoscope
