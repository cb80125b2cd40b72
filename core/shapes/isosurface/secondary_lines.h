// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/roots/column_table.h"
#include "core/roots/line_columns.h"
#include "core/shapes/rays/container.h"
#include "core/shapes/rays/ray_batch.h"

namespace isoscope {

/// Rays that begin on a surface (shadows, reflections, refractions), as lines for a root finder. At their
/// beginning no sign is certain, and hits before `nearLimit` do not count: lines leave that stretch out.
/// Keeps its memory.
class SecondaryLines {
  public:
    /// The way back along the rays: from where each leaves the container, or ends in it, to its beginning.
    /// There the function is outside for certain until the line comes near something, for many lines at once.
    /// Empty lines for rays that do not come through the container between `nearLimit` and ends[i].
    /// `passages` are those of the rays' whole lines.
    void reverse(const RayBatch& rays, const ContainerPassages& passages, double nearLimit,
                 const double* ends);

    /// The rays from `nearLimit` on. `passages` begin with the rays (ContainerPassages::beginWithRays).
    void start(const RayBatch& rays, const ContainerPassages& passages, double nearLimit);

    /// One line a ray. Valid until the next reverse() or start().
    LineColumns columns() const;

    /// The place `t` of line i, by the ray's own t. Infinite if t is and the line is not reversed.
    double onRay(std::size_t i, double t) const { return table_[origin][i] + (reversed_ ? -t : t); }
    /// Whether a reversed line ends at the container's wall: elsewhere what it ends in is no wall.
    bool endsAtWall(std::size_t i) const { return endsAtWall_[i] != 0; }

  private:
    enum Column : std::size_t {
        originX,
        originY,
        originZ,
        directionX,
        directionY,
        directionZ,
        near,
        far,
        origin,  ///< where the line's t = 0 is on the ray
        columnCount
    };

    void prepare(const RayBatch& rays, bool reversed);
    void place(const RayBatch& rays, std::size_t i, double begin);

    ColumnTable<columnCount> table_;
    std::vector<std::uint8_t> endsAtWall_;
    bool reversed_ = false;
};

}  // namespace isoscope
