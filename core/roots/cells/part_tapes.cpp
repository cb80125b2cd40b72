// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/cells/part_tapes.h"

#include "core/evaluate/prepared_function.h"

namespace isoscope {

PartTapes::PartTapes(const PreparedFunction& function, LazyUnionParts& parts)
    : parts_(parts), simplifier_(function.links()) {}

bool PartTapes::begin() {
    met_.clear();
    return !parts_.get().empty();
}

bool PartTapes::add(const LineBundle& lines) {
    if (!parts_.get().cover(lines)) return false;
    parts_.get().meet(lines, meetings_);
    for (const UnionParts::Meeting& meeting : meetings_) met_.push_back(meeting.part);
    return true;
}

bool PartTapes::add(const glm::dvec3& point) {
    const std::size_t before = met_.size();
    parts_.get().meet(point, met_);
    return met_.size() > before;
}

const SimplifiedTape& PartTapes::make() {
    parts_.get().decide(met_, decided_);
    simplifier_.simplify(decided_, tape_);
    return tape_;
}

}  // namespace isoscope
