// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/roots/lipschitz/lipschitz_search.h"

namespace isoscope {

/// POV-Ray's memory of the last interval without a root (docs/povray/solver.md, "The search"), applied to
/// lines after they were searched: what the memory would have dismissed is taken out of their roots.
class MissMemory {
  public:
    /// The next line, in order. `bound` is M. Returns true when a search of this line was dismissed.
    bool apply(const LineQuery& query, const SearchTrail& trail, double bound, RootList& roots);

  private:
    bool dismisses(const glm::dvec3& start, const glm::dvec3& end, double bound) const;

    bool filled_ = false;
    glm::dvec3 start_{0};
    glm::dvec3 end_{0};
    double lowest_ = 0;
};

}  // namespace isoscope
