// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/lipschitz/miss_memory.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace isoscope {

bool MissMemory::apply(const LineQuery& query, const SearchTrail& trail, double bound, RootList& roots) {
    const glm::dvec3 end = query.origin + query.far * query.direction;
    for (int search = 0; search < trail.count; ++search) {
        const double from = trail.starts[static_cast<std::size_t>(search)];
        const glm::dvec3 start = query.origin + from * query.direction;
        if (dismisses(start, end, bound)) {
            std::erase_if(roots,
                          [&](const Root& root) { return root.kind == RootKind::crossing && root.t > from; });
            return true;
        }
        filled_ = trail.missed && search == trail.count - 1;
        start_ = start;
        end_ = end;
        lowest_ = trail.lowest;
    }
    return false;
}

bool MissMemory::dismisses(const glm::dvec3& start, const glm::dvec3& end, double bound) const {
    if (!filled_) return false;
    const double moved = std::max(glm::distance(start, start_), glm::distance(end, end_));
    return lowest_ - bound * moved > 0;
}

}  // namespace isoscope
