// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/shapes/patches/mesh.h"

namespace isoscope {

/// A Bezier surface of 4 by 4 points, drawn as POV-Ray draws it: as triangles with the surface's own normals
/// at their corners, 2^steps along each side unless fewer are flat enough.
class BicubicPatch : public Shape {
  public:
    using Points = std::array<glm::dvec3, 16>;  ///< four rows; u runs along a row

    /// Steps from 0 to 8. As in POV-Ray, `uSteps` divide the way from the first row to the last, `vSteps`
    /// each row. `corners` are u and v of points 1, 4, 16 and 13.
    BicubicPatch(const Points& points, int uSteps, int vSteps, double flatness,
                 const std::array<glm::dvec2, 4>& corners = wholeSquare);
    static constexpr std::array<glm::dvec2, 4> wholeSquare{glm::dvec2(0, 0), glm::dvec2(1, 0),
                                                           glm::dvec2(1, 1), glm::dvec2(0, 1)};

    void intersect(const Ray& ray, RayInterval interval, TraceContext& context,
                   HitList& hits) const override {
        mesh_->intersect(ray, interval, context, hits);
    }
    void nearest(std::span<const Ray> rays, TraceContext& context,
                 std::span<NearestHit> nearest) const override {
        mesh_->nearest(rays, context, nearest);
    }
    bool contains(const glm::dvec3&, TraceContext&) const override { return false; }
    bool isPatch() const override { return true; }
    /// Those of its points, as in POV-Ray.
    Bounds bounds() const override { return bounds_; }
    Bounds boundsWithin(const Bounds& room) const override { return mesh_->boundsWithin(room); }
    std::optional<glm::dvec2> surfacePlace(const glm::dvec3& point) const override {
        return mesh_->surfacePlace(point);
    }

  private:
    std::shared_ptr<const Mesh> mesh_;
    Bounds bounds_;
};

}  // namespace isoscope
