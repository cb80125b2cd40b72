// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/cells/part_march.h"

#include <algorithm>
#include <limits>

namespace isoscope {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

PartMarch::PartMarch(const UnionParts& parts, MarchKernel& march, NewtonPolish& polish,
                     CrossingSettler& settler)
    : parts_(parts), march_(march), polish_(polish), settler_(settler) {
    met_.reserve(batchLanes);
}

void PartMarch::run(const LineColumns& lines, std::size_t first, std::size_t count, const LineBundle& bundle,
                    double sufficient, double* fars, FirstRoots& roots) {
    if (!parts_.cover(bundle)) return;
    begin(lines, first, count, fars);
    parts_.meet(bundle, meetings_);
    double furthest = bundle.far;
    for (const UnionParts::Meeting& meeting : meetings_) {
        if (meeting.near > furthest) break;
        const UnionParts::Part& part = parts_[meeting.part];
        gather(lines, first, count, part.box);
        if (numbers_.empty()) continue;
        search(part.tape, sufficient, first, roots);
        furthest = *std::max_element(reach_.begin(), reach_.begin() + count);
    }
    for (std::size_t k = 0; k < count; ++k) {
        if (outcomes_[k] != Outcome::crossing) roots.crossings[FirstRoots::t][first + k] = FirstRoots::none;
        if (outcomes_[k] == Outcome::settled) roots.others.push_back(settled_[k]);
        if (outcomes_[k] == Outcome::wall) roots.entryWalls.push_back(first + k);
        if (outcomes_[k] != Outcome::notPlain) fars[k] = -infinity;
    }
}

void PartMarch::begin(const LineColumns& lines, std::size_t first, std::size_t count, const double* fars) {
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t k = 0; k < count; ++k) perSpeed_[axis][k] = 1 / lines.direction[axis][first + k];
    std::copy_n(fars, count, reach_.begin());
    outcomes_.fill(Outcome::none);
}

/// The lines that meet a box, cut where they leave it, or where something is known to be in front. Their
/// beginnings, outside the box, are certain.
void PartMarch::gather(const LineColumns& lines, std::size_t first, std::size_t count,
                       const LineRegion& box) {
    std::array<double, batchLanes> enter, leave;
    for (std::size_t k = 0; k < count; ++k) enter[k] = lines.near[first + k], leave[k] = reach_[k];
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double low = box.low[static_cast<int>(axis)], high = box.high[static_cast<int>(axis)];
        for (std::size_t k = 0; k < count; ++k) {
            const double origin = lines.origin[axis][first + k];
            const double toLow = (low - origin) * perSpeed_[axis][k],
                         toHigh = (high - origin) * perSpeed_[axis][k];
            // Not a number in a wall of the box, which is wider than need be.
            enter[k] = std::max(enter[k], std::min(toLow, toHigh));
            leave[k] = std::min(leave[k], std::max(toLow, toHigh));
        }
    }
    numbers_.clear();
    for (std::size_t k = 0; k < count; ++k)
        if (enter[k] < leave[k]) numbers_.push_back(k);
    if (numbers_.empty()) return;
    starts_.reset(numbers_.size());
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
        const std::size_t k = numbers_[i], line = first + k;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            met_[originX + axis][i] = lines.origin[axis][line];
            met_[directionX + axis][i] = lines.direction[axis][line];
        }
        met_[near][i] = lines.near[line];
        met_[far][i] = leave[k];
        // The first piece is half of the way.
        if (enter[k] > lines.near[line]) starts_.set(i, 1, {enter[k], 1, 0.4 * (leave[k] - enter[k])});
    }
}

/// Looks for a part along these lines.
void PartMarch::search(const SimplifiedTape& tape, double sufficient, std::size_t first, FirstRoots& roots) {
    const LineColumns columns{numbers_.size(),
                              {met_[originX], met_[originX + 1], met_[originX + 2]},
                              {met_[directionX], met_[directionX + 1], met_[directionX + 2]},
                              met_[near],
                              met_[far]};
    MarchKernel::Results& found = march_.run(columns, 0, columns.count, starts_, sufficient, tape);
    for (const std::size_t i : found.entryWalls) end(i, Outcome::wall);
    for (const std::size_t i : found.insideEnds) end(i, Outcome::notPlain);
    for (const MarchKernel::Line& line : found.rest) end(line.line, Outcome::notPlain);
    if (found.crossings.empty()) return;
    // Where a part is left that a line has begun in, the line may be in another one.
    leaving_.assign(columns.count, false);
    for (std::size_t k = 0; k < found.crossings.size(); ++k)
        leaving_[static_cast<std::size_t>(found.crossings[MarchKernel::foundLine][k])] =
            found.crossings[MarchKernel::steepness][k] > 0;
    found_.clear(columns.count);
    polish_.run(found.crossings, found_, &tape);
    for (std::size_t i = 0; i < columns.count; ++i) {
        if (found_.crossings[FirstRoots::t][i] == FirstRoots::none) continue;
        if (leaving_[i]) continue;
        const std::size_t k = numbers_[i];
        for (std::size_t c = 0; c < FirstRoots::columnCount; ++c)
            roots.crossings[c][first + k] = found_.crossings[c][i];
        reach_[k] = found_.crossings[FirstRoots::t][i];
        outcomes_[k] = Outcome::crossing;
    }
    for (std::size_t i = 0; i < columns.count; ++i)
        if (leaving_[i]) end(i, Outcome::notPlain);
    if (polish_.unsettled().empty()) return;
    for (const FirstRoots::Other& root : settler_.run(columns, polish_.unsettled(), tape)) {
        if (leaving_[root.line]) continue;
        const std::size_t k = numbers_[root.line];
        settled_[k] = root;
        settled_[k].line = first + k;
        reach_[k] = root.root.t;
        outcomes_[k] = Outcome::settled;
    }
}

/// No other part matters to this line.
void PartMarch::end(std::size_t i, Outcome outcome) {
    outcomes_[numbers_[i]] = outcome;
    reach_[numbers_[i]] = -infinity;
}

}  // namespace isoscope
