// SPDX-License-Identifier: GPL-3.0-or-later
// The warps have no formula in the specification; these were found by looking up coordinates through them in
// POV-Ray 3.7 and agree with it to its last digits.
#include "core/function/patterns/pattern_warp.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <optional>
#include <utility>

#include "core/function/builtins/formula_blocks.h"
#include "core/function/patterns/pattern_call.h"
#include "core/function/point_table.h"
#include "core/numeric/crackle.h"
#include "core/numeric/interval.h"

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

/// One coordinate of the random vector of a block of space: that of crackle's points, each below 1.
class BlockVector : public PointTable {
  public:
    explicit BlockVector(std::size_t axis) : axis_(axis) {}

    double value(const std::array<double, 3>& block) const override {
        std::array<std::int64_t, 3> cell{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            // Numbers of cells count modulo 4096.
            const double rest = std::fmod(std::floor(block[axis]), 4096);
            cell[axis] = std::isfinite(rest) ? static_cast<std::int64_t>(rest) : 0;
        }
        return cracklePoint(cell[0], cell[1], cell[2])[axis_] - static_cast<double>(cell[axis_]);
    }
    bool hasRanges() const override { return true; }
    Straightness straightness(const std::array<Interval, 3>& box, const std::array<double, 3>&,
                              const std::array<double, 3>&) const override {
        return isWithinOne(box) ? Straightness{0, 0} : Straightness{1, 1};
    }

  private:
    static bool isWithinOne(const std::array<Interval, 3>& box) {
        return std::ranges::all_of(
            box, [](const Interval& side) { return std::floor(side.low) == std::floor(side.high); });
    }
    Interval rangeIn(const std::array<Interval, 3>& box) const override {
        if (!isWithinOne(box)) return {0, 1, false};
        return Interval::point(value({box[0].low, box[1].low, box[2].low}));
    }

    std::size_t axis_;
};

PatternPoint blockVector(const PatternPoint& block) {
    PatternPoint result;
    FunctionGraph& graph = block[0].graph();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        CrackleSettings settings;
        settings.table = std::make_shared<const BlockVector>(axis);
        result[axis] = {graph, graph.crackle(settings, block[0].node(), block[1].node(), block[2].node())};
    }
    return result;
}

/// The way to a point from the middle of the hole in its block.
PatternPoint wayFromHole(const BlackHoleWarp& warp, const PatternPoint& p) {
    PatternPoint way, block;
    bool repeats = false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        way[axis] = p[axis];
        block[axis] = p[axis].number(0);
        if (warp.repeat[axis] > 0) {
            repeats = true;
            block[axis] = floor(p[axis] / warp.repeat[axis]);
            way[axis] = p[axis] - block[axis] * warp.repeat[axis];
        }
        way[axis] = way[axis] - warp.center[axis];
    }
    if (!repeats || warp.turbulence == std::array<double, 3>{0, 0, 0}) return way;
    const PatternPoint moved = blockVector(block);
    for (std::size_t axis = 0; axis < 3; ++axis) way[axis] = way[axis] - warp.turbulence[axis] * moved[axis];
    return way;
}

PatternPoint warped(const BlackHoleWarp& warp, const PatternPoint& p) {
    const PatternPoint away = wayFromHole(warp, p);
    const Expression distance = length(away[0], away[1], away[2]);
    const Expression depth = max(1 - distance / warp.radius, 0);
    const Expression pull = min(warp.strength * pow(depth, depth.number(warp.falloff)), 1);
    const Expression inside = select(distance - warp.radius, warp.inverse ? -pull : pull, pull.number(0));
    PatternPoint result;
    for (std::size_t axis = 0; axis < 3; ++axis) result[axis] = p[axis] + away[axis] * inside;
    return result;
}

/// The sum of the expressions times their factors, without those of factor 0.
Expression sumOf(std::initializer_list<std::pair<double, Expression>> parts) {
    std::optional<Expression> sum;
    for (const auto& [factor, part] : parts) {
        if (factor == 0) continue;
        const Expression term = factor == 1 ? part : factor == -1 ? -part : factor * part;
        sum = sum ? *sum + term : term;
    }
    return sum.value_or(parts.begin()->second.number(0));
}

/// (u, v) on the wrapped sheet and the distance from it, turned to the orientation; not a rotation, but for
/// the axes.
PatternPoint oriented(const std::array<double, 3>& n, Expression u, Expression v, Expression distance) {
    return {sumOf({{n[1] + n[2], u}, {n[0], distance}}), sumOf({{n[0] + n[2], v}, {-n[1], distance}}),
            sumOf({{-n[0], u}, {n[1], v}, {n[2], distance}})};
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
