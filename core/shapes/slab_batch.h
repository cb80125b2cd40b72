// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/roots/column_table.h"
#include "core/shapes/bounds.h"
#include "core/shapes/ray.h"

namespace isoscope {

/// Many rays made ready for slab tests as SlabRay, to be tested side by side in vectors. Keeps its memory.
class SlabBatch {
  public:
    /// Numbers behind the last ray's that findMeeting() may read.
    static constexpr std::size_t padding = LineColumns::padding;

    void assign(std::span<const Ray> rays);

    /// `numbers` become those of the rays that may meet the box between t = 0 and their own of `farthest`,
    /// ascending; no ray is left out that SlabRay::mayMeet would let through. `farthest` goes on for
    /// `padding` entries behind the last ray's.
    void findMeeting(const Bounds& box, const double* farthest, std::vector<std::uint32_t>& numbers) const;

  private:
    enum Column : std::size_t { originX, originY, originZ, inverseX, inverseY, inverseZ, reach, columnCount };

    /// `reach` is negative for what is no ray, else infinite.
    ColumnTable<columnCount> columns_;
};

}  // namespace isoscope
