// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shapes/rays/ray_batch.h"
#include "core/shapes/rays/span_batch.h"

namespace isoscope {

/// What a line meets in one piece: CSG with such solids needs no list of hits.
class ConvexSolid {
  public:
    virtual ~ConvexSolid() = default;

    /// Where the lines of the rays run inside, with the same numbers as Shape::intersect, to the bit.
    virtual void spans(const RayBatch& rays, SpanBatch& spans) const = 0;
};

}  // namespace isoscope
