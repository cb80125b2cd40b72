// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shapes/shape.h"

namespace isoscope {

/// The keyword `inverse`: inside and outside change places, normals turn over; the surface is the same.
class InverseShape : public Shape {
  public:
    explicit InverseShape(ShapePointer shape) : shape_(std::move(shape)) {}

    const ShapePointer& shape() const { return shape_; }

    void intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const override;
    void nearest(std::span<const Ray> rays, TraceContext& context,
                 std::span<NearestHit> nearest) const override;
    void allHits(std::span<const Ray> rays, TraceContext& context, std::span<HitList> hits) const override;
    bool contains(const glm::dvec3& point, TraceContext& context) const override;
    /// Infinite: a ray may be inside without ever meeting the surface.
    Bounds bounds() const override { return {}; }

  private:
    ShapePointer shape_;
};

}  // namespace isoscope
