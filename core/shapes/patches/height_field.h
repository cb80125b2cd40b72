// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/image/raster_file.h"
#include "core/shapes/shape.h"
#include "core/shapes/transform.h"

namespace isoscope {

/// A grid of heights over the unit square, x to the right and z away: at least 2 by 2.
struct HeightGrid {
    int columns = 0;
    int rows = 0;
    std::vector<double> heights;  ///< 0 to 1; row by row from z = 0

    /// The height at a grid point. No bounds are checked.
    double at(int column, int row) const {
        return heights[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                       static_cast<std::size_t>(column)];
    }
};

/// The heights that an image means (docs/povray/primitives.md, section 4): grey over 65536, as well that of
/// colours of more than 8 bits, a palette's index over 256, or red and green as the two bytes of a number
/// over 65536. Its bottom row lies at z = 0.
HeightGrid heightGrid(const Raster& raster);

/// Two triangles for each square of four heights, without walls. Inside is everything below the unit square's
/// surface, under the water level too, as in POV-Ray.
class HeightField : public Shape {
  public:
    HeightField(HeightGrid grid, double waterLevel, bool smooth);

    void intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const override;
    void nearest(std::span<const Ray> rays, TraceContext& context,
                 std::span<NearestHit> nearest) const override;
    bool contains(const glm::dvec3& point, TraceContext& context) const override;
    Bounds bounds() const override { return bounds_; }
    /// The inside goes down without end.
    Bounds boundsWithin(const Bounds& room) const override { return room; }
    bool boundsCutIntersections() const override { return false; }
    /// Smooth normals are blended after they have been stretched with the field, as in POV-Ray.
    ShapePointer awareOf(const Transform& place) const override;

  private:
    class Walk;

    glm::dvec3 pointAt(int column, int row) const;
    /// The average of the normals of the squares around a grid point.
    glm::dvec3 smoothNormal(int column, int row) const;
    /// Between those of the corners of a square.
    glm::dvec3 smoothNormalAt(const glm::dvec3& point, int column, int row) const;
    /// Whether a ray that stays between these heights may meet the two triangles of a square.
    bool mayReach(int column, int row, double low, double high) const;
    /// Hits in two triangles of a square; whether there was one.
    bool meetCell(const Walk& walk, int column, int row, RayInterval interval, HitList& hits) const;
    /// Squares along the ray in their order, until `enough()` after one that was hit.
    template <class Enough>
    void trace(const Ray& ray, RayInterval interval, HitList& hits, Enough enough) const;

    std::shared_ptr<const HeightGrid> shared_;
    const HeightGrid& grid_;
    double waterLevel_;
    bool smooth_;
    Transform place_;
    Bounds bounds_;
};

}  // namespace isoscope
