// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "core/evaluate/tape/tape_simplifier.h"
#include "core/roots/cells/union_parts.h"
#include "core/roots/certified/line_bundle.h"

namespace isoscope {

class PreparedFunction;

/// What is left of a union where nothing but some of its parts is met: a tape with the same sign.
class PartTapes {
  public:
    /// `parts` are those of the function; both must outlive the tapes.
    PartTapes(const PreparedFunction& function, LazyUnionParts& parts);

    /// From now on nothing is met. False where the function has no parts: then nothing else may be asked for.
    bool begin();
    /// What lines meet. False where that is not known.
    bool add(const LineBundle& lines);
    /// What is met at a point. False where that is nothing.
    bool add(const glm::dvec3& point);

    /// Whether something is met; where not, all is outside.
    bool meets() const { return !met_.empty(); }
    /// The tape, if something is met; valid until the next one is made.
    const SimplifiedTape& make();

  private:
    LazyUnionParts& parts_;
    TapeSimplifier simplifier_;
    std::vector<std::uint32_t> met_;
    std::vector<UnionParts::Meeting> meetings_;
    DecidedChoices decided_;
    SimplifiedTape tape_;
};

}  // namespace isoscope
