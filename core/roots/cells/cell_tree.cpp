// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/cells/cell_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include "core/evaluate/prepared_function.h"
#include "core/roots/cells/short_tapes.h"

namespace isoscope {

namespace {

/// Cells are divided at most so often.
constexpr int deepest = 16;
/// A cell is divided into so many on each axis; the root, of which little is decided anywhere, into more.
constexpr std::size_t parts = 2, partsOfRoot = 4;
/// A bundle takes up at most this part of what is free around a cell in its box.
constexpr double widestPart = 0.75;
/// Of the tapes that are kept, about 50 bytes each. Memory that is touched for the first time costs more than
/// what is made anew in memory that is there.
constexpr std::size_t mostInstructions = 1 << 16;
/// Bytes of cells and their divisions.
constexpr std::size_t mostMemory = 1 << 26;

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

/// Half the width of the box of the cell that all others are in, a cube around the region.
double halfWidthOf(const LineRegion& region) { return largest(region.high - region.low); }

LineRegion rootBox(const LineRegion& region) {
    const glm::dvec3 center = 0.5 * (region.low + region.high);
    return {center - halfWidthOf(region), center + halfWidthOf(region)};
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
    : settings_(settings), links_(function.links()), boxes_(function, settings) {}

void CellTree::begin(const LineBundle& bundle) {
    const LineRegion reached = regionOf(bundle);
    const bool usual = settings_.region && holds(rootBox(*settings_.region), reached);
    const LineRegion& region = usual ? *settings_.region : reached;
    if (cells_.empty() || memory_ > mostMemory || !same(region, region_)) beginIn(region);
}

void CellTree::beginIn(const LineRegion& region) {
    region_ = region;
    instructions_ = memory_ = 0;
    madeFor_ = nullptr;
    kept_.clear();
    cells_.clear();
    Cell& root = cells_.emplace_back();
    root.center = 0.5 * (region.low + region.high);
    root.halfWidth = halfWidthOf(region);
    root.tape = &links_.whole();
    root.length = root.tape->instructions.size();
}

const CellTree::Cell& CellTree::find(const LineBundle& bundle, double t) {
    if (instructions_ > mostInstructions) dropTapes();
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
    while (levels-- > 0 && cell->sign == 0 && isLong(*cell)) {
        if (!cell->division) divide(*cell);
        Cell& next = childAt(*cell, partsOf(*cell), place);
        if (largest(glm::abs(center - next.center)) + reach >= next.halfWidth) break;
        cell = &next;
    }
    if (cell->sign <= 0) keepTape(*cell);
    return *cell;
}

bool CellTree::beginPoints() {
    if (!settings_.region) return false;
    const double halfWidth = halfWidthOf(*settings_.region);
    if (!(halfWidth > 0) || !std::isfinite(halfWidth)) return false;
    beginIn(*settings_.region);
    return true;
}

const CellTree::Cell* CellTree::at(const glm::dvec3& point) {
    if (!holds(region_, {point, point})) return nullptr;
    if (instructions_ > mostInstructions) dropTapes();
    if (memory_ > mostMemory) beginIn(region_);
    Cell* cell = &cells_.front();
    for (int level = 0; level < deepest && cell->sign == 0; ++level) {
        if (!cell->division) {
            if (!isWorthDividing(*cell)) break;
            divide(*cell);
        }
        cell = &childAt(*cell, partsOf(*cell), point);
    }
    if (cell == &cells_.front()) return nullptr;
    if (cell->sign == 0) keepTape(*cell);
    return cell;
}

/// The child of a divided cell, `count` of them on each axis, that a place is in, or next to.
CellTree::Cell& CellTree::childAt(const Cell& cell, std::size_t count, const glm::dvec3& place) {
    std::size_t child = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double along = (place[axis] - cell.center[axis]) / cell.halfWidth + 0.5;
        child = child * count + static_cast<std::size_t>(std::clamp(along * static_cast<double>(count), 0.0,
                                                                    static_cast<double>(count - 1)));
    }
    return *cell.division->children[child];
}

/// Into how many it is divided on each axis.
std::size_t CellTree::partsOf(const Cell& cell) const {
    return &cell == &cells_.front() ? partsOfRoot : parts;
}

/// Whether another point in a cell that is not divided is a reason to do that.
bool CellTree::isWorthDividing(Cell& cell) {
    // About what it costs, in values of points.
    constexpr std::uint32_t price = 8;
    if (++cell.points <= price || !isLong(cell)) return false;
    const Cell* before = &cell;
    for (int level = 0; level < 3; ++level) before = before->parent != nullptr ? before->parent : before;
    return before->parent == nullptr || *cell.length < *before->length;
}

void CellTree::divide(Cell& cell) {
    const SimplifiedTape& tape = tapeOf(cell);
    const std::size_t count = &cell == &cells_.front() ? partsOfRoot : parts;
    const double width = cell.halfWidth / static_cast<double>(count);
    cell.division = std::make_unique<Division>();
    Division& division = *cell.division;
    division.children.resize(count * count * count);
    for (std::size_t child = 0; child < division.children.size(); ++child) {
        Cell& made = cells_.emplace_back();
        division.children[child] = &made;
        const std::array<std::size_t, 3> number{child / count / count, child / count % count, child % count};
        for (int axis = 0; axis < 3; ++axis)
            made.center[axis] = cell.center[axis] - 0.5 * cell.halfWidth +
                                (static_cast<double>(number[static_cast<std::size_t>(axis)]) + 0.5) * width;
        made.halfWidth = width;
        made.parent = &cell;
        made.number = child;
        boxes_.place(made.center, glm::dvec3(width), child);
    }
    boxes_.setBase(tape);
    boxes_.enclose(division.children.size());
    for (std::size_t child = 0; child < division.children.size(); ++child)
        division.children[child]->sign = boxes_.sign(child);
    division.choices = boxes_.choices();
    division.places.reserve(division.choices.size());
    for (const Instruction& instruction : tape.instructions)
        if (isChoice(instruction.operation))
            division.places.push_back(
                links_.chains().places[links_.whole().links[instruction.number].choice]);
    decide(cell, division.decided);
    memory_ += division.children.size() * sizeof(Cell) +
               division.choices.size() * (sizeof(LaneChoices) + sizeof(std::uint32_t)) +
               2 * division.decided.first.size() * sizeof(std::uint64_t);
}

/// What is decided all over the box of a cell.
void CellTree::decide(const Cell& cell, DecidedChoices& decided) const {
    if (cell.parent == nullptr) return decided.reset(links_);
    const Division& division = *cell.parent->division;
    decided = division.decided;
    decided.add(division.places, division.choices, std::uint64_t(1) << cell.number);
}

void CellTree::makeTape(Cell& cell, SimplifiedTape& tape) {
    decide(cell, decided_);
    boxes_.simplify(decided_, tape);
    cell.length = tape.instructions.size();
}

/// The tape of a cell, valid until that of another one is asked for.
const SimplifiedTape& CellTree::tapeOf(Cell& cell) {
    if (cell.tape != nullptr) return *cell.tape;
    if (madeFor_ != &cell) makeTape(cell, made_);
    madeFor_ = &cell;
    return made_;
}

bool CellTree::isLong(Cell& cell) {
    if (!cell.length) tapeOf(cell);
    return *cell.length > ShortTapes::shortLength;
}

void CellTree::keepTape(Cell& cell) {
    cell.lastUse = ++uses_;
    if (cell.tape != nullptr) return;
    auto tape = std::make_unique<SimplifiedTape>();
    if (madeFor_ == &cell)
        *tape = made_;
    else
        makeTape(cell, *tape);
    cell.ownTape = std::move(tape);
    cell.tape = cell.ownTape.get();
    instructions_ += *cell.length;
    kept_.push_back(&cell);
}

/// Of the tapes that are kept, the half that was not used for longest; they can be made again.
void CellTree::dropTapes() {
    const auto middle = kept_.begin() + static_cast<std::ptrdiff_t>(kept_.size() / 2);
    std::nth_element(kept_.begin(), middle, kept_.end(),
                     [](const Cell* a, const Cell* b) { return a->lastUse > b->lastUse; });
    for (auto cell = middle; cell != kept_.end(); ++cell) {
        instructions_ -= *(*cell)->length;
        (*cell)->tape = nullptr;
        (*cell)->ownTape.reset();
    }
    kept_.erase(middle, kept_.end());
}

}  // namespace isoscope
