// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/shapes/mesh.h"

namespace isoscope {

/// A Bezier surface of 4 by 4 points, drawn as POV-Ray draws it: as triangles with the surface's own normals
/// at their corners, 2^steps along each side unless fewer are flat enough.
class BicubicPatch : public Shape {
  public:
    using Points = std::array<glm::dvec3, 16>;  ///< four rows; u runs along a row

    /// Steps from 0 to 8.
    BicubicPatch(const Points& points, int uSteps, int vSteps, double flatness);

    void intersect(const Ray& ray, RayInterval interval, TraceContext& context,
                   HitList& hits) const override {
        mesh_->intersect(ray, interval, context, hits);
    }
    void nearest(std::span<const Ray> rays, TraceContext& context,
                 std::span<NearestHit> nearest) const override {
        mesh_->nearest(rays, context, nearest);
    }
    bool contains(const glm::dvec3&, TraceContext&) const override { return false; }
    Bounds bounds() const override { return mesh_->bounds(); }

  private:
    std::shared_ptr<const Mesh> mesh_;
};

}  // namespace isoscope
