// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/shapes/combined/convex_solid.h"
#include "core/shapes/rays/hit_batch.h"
#include "core/shapes/shape.h"
#include "core/shapes/transform.h"

namespace isoscope {

/// What convex solids have in common, and what others of them are cut out of it, for many rays at once: a ray
/// is inside of each for one piece of its line, so that the first border that no other part hides is found by
/// comparing the ends of these pieces.
class ConvexIntersection {
  public:
    static constexpr std::size_t partLimit = 8;

    /// The common inside of the parts of an intersection, as Csg keeps them. Nothing unless all of them are
    /// convex, complements of convex solids or again intersections of such parts, placed anywhere, and at
    /// most partLimit.
    static std::optional<ConvexIntersection> of(std::span<const ShapePointer> parts);

    /// Shape::nearestInBatch. `doubtful` become the rays that have to be asked about one by one: those that
    /// pass a place where borders meet, or graze one, so that rounding would decide.
    void nearest(const RayBatch& rays, TraceContext& context, HitBatch& hits,
                 std::vector<std::uint32_t>& doubtful) const;

  private:
    struct Part {
        ShapePointer shape;
        const ConvexSolid* solid;
        Transform transform;
        bool moved;
        bool inverse;
        MaterialId material;
    };

    /// False when the shape is no such part.
    bool add(const ShapePointer& shape, const Transform& around, bool inverse, MaterialId material);

    std::vector<Part> parts_;
};

}  // namespace isoscope
