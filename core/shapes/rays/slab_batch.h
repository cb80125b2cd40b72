// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/roots/column_table.h"
#include "core/shapes/bounds.h"
#include "core/shapes/rays/ray_batch.h"
#include "core/shapes/rays/ray_bundle.h"

namespace isoscope {

/// Many rays made ready for slab tests as SlabRay, to be tested side by side in vectors. No ray is left out
/// of an answer that SlabRay::mayMeet would let through. Keeps its memory.
class SlabBatch {
  public:
    /// Numbers behind the last ray's that findMeeting() may read.
    static constexpr std::size_t padding = LineColumns::padding;

    /// Replaces the rays by copies of these. One that is not finite meets no box, but makes bundle() hold all
    /// of space.
    void assign(const RayBatch& rays);

    /// All rays seen as one.
    const RayBundle& bundle() const { return bundle_; }

    /// `numbers` become those of the rays that may meet the box between t = 0 and their own of `farthest`,
    /// ascending. `farthest` goes on for `padding` entries behind the last ray's.
    void findMeeting(const Bounds& box, const double* farthest, std::vector<std::uint32_t>& numbers) const;

    /// The same for `count` rays, those with the numbers `among`, which goes to `kept`, with room for as
    /// many; answers how many those are. Without `farthest` rays go on for ever.
    std::size_t keepMeeting(const Bounds& box, const double* farthest, const std::uint32_t* among,
                            std::size_t count, std::uint32_t* kept) const;

  private:
    enum Column : std::size_t { originX, originY, originZ, inverseX, inverseY, inverseZ, reach, columnCount };

    /// `reach` is negative for what is no ray, else infinite.
    ColumnTable<columnCount> columns_;
    RayBundle bundle_{Bounds(), Bounds()};
};

}  // namespace isoscope
