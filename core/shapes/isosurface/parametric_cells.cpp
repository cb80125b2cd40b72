// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/isosurface/parametric_cells.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/evaluate/prepared_function.h"

namespace isoscope {

namespace {

/// More than the rounding errors of the few sums and products that bound a cell.
constexpr double rounding = 1e-14;

double middleOf(const SlopeRange& range) { return range.low + (range.high - range.low) / 2; }

}  // namespace

ParametricCells::ParametricCells(const Tapes& tapes, std::span<const double> parameters,
                                 const glm::dvec2& low, const glm::dvec2& high) {
    for (const auto& tape : tapes) {
        const auto function = PreparedFunction::of(tape, parameters);
        enclosures_.emplace_back(*function);
        points_.emplace_back(function);
    }
    root_ = enclose(low, high);
}

ParametricPoint ParametricCells::point(const glm::dvec2& uv) {
    ++evaluations_;
    ParametricPoint result;
    for (int axis = 0; axis < 3; ++axis) {
        const ValueAndGradient found = points_[static_cast<std::size_t>(axis)].evaluate(uv.x, uv.y, 0);
        result.at[axis] = found.value;
        result.byU[axis] = found.gradient[0];
        result.byV[axis] = found.gradient[1];
    }
    return result;
}

ParametricCell ParametricCells::enclose(const glm::dvec2& low, const glm::dvec2& high) {
    ++evaluations_;
    ParametricCell cell;
    cell.low = low;
    cell.high = high;
    cell.sloped = true;
    const glm::dvec2 middle = cell.middle(), reach = high - low;
    const std::array<Interval, 3> whole{Interval{low.x, high.x}, Interval{low.y, high.y}, Interval::point(0)};
    const std::array<Interval, 3> inMiddle{Interval::point(middle.x), Interval::point(middle.y),
                                           Interval::point(0)};
    for (int axis = 0; axis < 3; ++axis) {
        IntervalGradientEvaluator& evaluator = enclosures_[static_cast<std::size_t>(axis)];
        const IntervalGradient over = evaluator.evaluate(whole);
        cell.box.low[axis] = over.value.low;
        cell.box.high[axis] = over.value.high;
        const SlopeRange u = over.slope[0], v = over.slope[1];
        const Interval center = evaluator.evaluate(inMiddle).value;
        const double size = std::max(std::abs(center.low), std::abs(center.high));
        const bool known = over.bounded() && u.isFinite() && v.isFinite() && !over.value.maybeUndefined &&
                           std::isfinite(size);
        cell.sloped = cell.sloped && known;
        if (!known) continue;
        cell.center[axis] = center.low + (center.high - center.low) / 2;
        cell.centerError = std::max(cell.centerError, center.high - center.low + rounding * size);
        cell.slopeU[axis] = middleOf(u);
        cell.slopeV[axis] = middleOf(v);
        cell.spreadU[axis] = std::max(u.high - cell.slopeU[axis], cell.slopeU[axis] - u.low) * (1 + rounding);
        cell.spreadV[axis] = std::max(v.high - cell.slopeV[axis], cell.slopeV[axis] - v.low) * (1 + rounding);
        // The mean value theorem: often a tighter box than the values' own.
        const double most = (u.size() * reach.x + v.size() * reach.y) / 2 * (1 + rounding) + cell.centerError;
        cell.box.low[axis] = std::max(cell.box.low[axis], cell.center[axis] - most);
        cell.box.high[axis] = std::min(cell.box.high[axis], cell.center[axis] + most);
    }
    return cell;
}

std::array<ParametricCell, 2>& ParametricCells::split(ParametricCell& cell,
                                                      std::array<ParametricCell, 2>& room) {
    if (cell.halves) return *cell.halves;
    const glm::dvec2 side = cell.high - cell.low;
    const double lengthU = (glm::length(cell.slopeU) + glm::length(cell.spreadU)) * side.x,
                 lengthV = (glm::length(cell.slopeV) + glm::length(cell.spreadV)) * side.y;
    const bool alongU = cell.sloped ? lengthU >= lengthV : side.x >= side.y;
    const glm::dvec2 middle = cell.middle();
    const glm::dvec2 firstHigh =
        alongU ? glm::dvec2(middle.x, cell.high.y) : glm::dvec2(cell.high.x, middle.y);
    const glm::dvec2 secondLow = alongU ? glm::dvec2(middle.x, cell.low.y) : glm::dvec2(cell.low.x, middle.y);
    room[0] = enclose(cell.low, firstHigh);
    room[1] = enclose(secondLow, cell.high);
    if (kept_ >= keptLimit) return room;
    kept_ += 2;
    cell.halves = std::make_unique<std::array<ParametricCell, 2>>(std::move(room));
    return *cell.halves;
}

}  // namespace isoscope
