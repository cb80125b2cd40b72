// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/cells/cell_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include "core/evaluate/prepared_function.h"

namespace isoscope {

namespace {

/// Tapes as short as this are not worth a smaller cell.
constexpr std::size_t shortTape = 24;
/// Cells are divided at most so often.
constexpr int deepest = 16;
/// A cell is divided into so many on each axis; the root, of which little is decided anywhere, into more.
constexpr std::size_t parts = 2, partsOfRoot = 4;
/// A bundle takes up at most this part of what is free around a cell in its box.
constexpr double widestPart = 0.75;
/// Of all cells, about 50 bytes each.
constexpr std::size_t mostInstructions = 1 << 20;

double largest(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

LineRegion regionOf(const LineBundle& bundle) {
    const auto at = [&](double t, double side) {
        return bundle.origin + t * bundle.direction +
               side * (bundle.originSpread + std::abs(t) * bundle.directionSpread);
    };
    return {glm::min(at(bundle.near, -1), at(bundle.far, -1)),
            glm::max(at(bundle.near, 1), at(bundle.far, 1))};
}

bool holds(const LineRegion& region, const LineRegion& other) {
    return glm::all(glm::lessThanEqual(region.low, other.low)) &&
           glm::all(glm::lessThanEqual(other.high, region.high));
}

bool same(const LineRegion& a, const LineRegion& b) { return a.low == b.low && a.high == b.high; }

/// The cell all others are in, a cube around the region.
CellTree::Cell rootOf(const LineRegion& region) {
    CellTree::Cell root;
    root.center = 0.5 * (region.low + region.high);
    root.halfWidth = largest(region.high - region.low);
    return root;
}

LineRegion boxOf(const CellTree::Cell& cell) {
    return {cell.center - cell.halfWidth, cell.center + cell.halfWidth};
}

}  // namespace

double CellTree::Cell::exit(const LineBundle& bundle) const {
    double end = bundle.far;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            const double speed = side * bundle.direction[axis] + bundle.directionSpread[axis];
            const double begin = side * (bundle.origin[axis] - center[axis]) + bundle.originSpread[axis];
            if (speed > 0) end = std::min(end, (halfWidth - begin) / speed);
        }
    return end;
}

CellTree::CellTree(const PreparedFunction& function, const RootSettings& settings)
    : settings_(settings), whole_(function.links().whole()), boxes_(function, settings) {}

void CellTree::begin(const LineBundle& bundle) {
    const LineRegion reached = regionOf(bundle);
    const bool usual = settings_.region && holds(boxOf(rootOf(*settings_.region)), reached);
    const LineRegion& region = usual ? *settings_.region : reached;
    if (!cells_.empty() && instructions_ <= mostInstructions && same(region, region_)) return;
    region_ = region;
    instructions_ = 0;
    cells_.clear();
    cells_.push_back(rootOf(region));
    cells_.front().tape = &whole_;
}

const CellTree::Cell& CellTree::find(const LineBundle& bundle, double t) {
    const glm::dvec3 center = bundle.origin + t * bundle.direction;
    const double reach = largest(bundle.originSpread + t * bundle.directionSpread);
    Cell* cell = &cells_.front();
    // The width of a cell is half that of its box, and what is free around it is half its width.
    const auto fits = [&](double width) { return reach < 0.5 * widestPart * width; };
    double width = cell->halfWidth / partsOfRoot;
    int levels = 0;
    for (; levels < deepest && fits(width); ++levels) width /= parts;
    // Somewhat ahead, so that the way is long.
    const double free = std::max(0.0, 0.5 * parts * width - reach);
    const glm::dvec3 place = center + free / largest(glm::abs(bundle.direction)) * bundle.direction;
    while (levels-- > 0 && cell->sign == 0 && cell->tape->instructions.size() > shortTape) {
        const std::size_t count = cell == &cells_.front() ? partsOfRoot : parts;
        if (cell->children.empty()) divide(*cell);
        std::size_t child = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const double along = (place[axis] - cell->center[axis]) / cell->halfWidth + 0.5;
            child = child * count + static_cast<std::size_t>(std::clamp(along * static_cast<double>(count),
                                                                        0.0, static_cast<double>(count - 1)));
        }
        Cell* const next = cell->children[child];
        if (largest(glm::abs(center - next->center)) + reach >= next->halfWidth) break;
        if (next->sign <= 0 && next->tape == nullptr) shorten(*cell, child);
        cell = next;
    }
    return *cell;
}

void CellTree::divide(Cell& cell) {
    const std::size_t count = &cell == &cells_.front() ? partsOfRoot : parts;
    cell.children.resize(count * count * count);
    const double width = cell.halfWidth / static_cast<double>(count);
    for (std::size_t child = 0; child < cell.children.size(); ++child) {
        Cell& made = cells_.emplace_back();
        cell.children[child] = &made;
        const std::array<std::size_t, 3> number{child / count / count, child / count % count, child % count};
        for (int axis = 0; axis < 3; ++axis)
            made.center[axis] = cell.center[axis] - 0.5 * cell.halfWidth +
                                (static_cast<double>(number[static_cast<std::size_t>(axis)]) + 0.5) * width;
        made.halfWidth = width;
        boxes_.place(made.center, glm::dvec3(width), child);
    }
    boxes_.setBase(*cell.tape);
    boxes_.enclose(cell.children.size());
    cell.choices = boxes_.choices();
    for (std::size_t child = 0; child < cell.children.size(); ++child)
        cell.children[child]->sign = boxes_.sign(child);
}

void CellTree::shorten(const Cell& parent, std::size_t child) {
    Cell& cell = *parent.children[child];
    boxes_.setBase(*parent.tape);
    boxes_.simplify(parent.choices, std::uint64_t(1) << child, cell.ownTape);
    cell.tape = &cell.ownTape;
    instructions_ += cell.ownTape.instructions.size();
}

}  // namespace isoscope
