// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shapes/shape.h"

namespace isoscope {

/// The keyword `no_shadow` on a part of CSG: shadow rays do not meet its surface, but what lies inside it still counts for
/// the other parts (measured on POV-Ray 3.7).
class ShadowlessShape : public Shape {
  public:
    explicit ShadowlessShape(ShapePointer shape) : shape_(std::move(shape)) {}

    const ShapePointer& shape() const { return shape_; }

    void intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const override;
    void nearest(std::span<const Ray> rays, TraceContext& context, std::span<NearestHit> nearest) const override;
    void allHits(std::span<const Ray> rays, TraceContext& context, std::span<HitList> hits) const override;
    bool contains(const glm::dvec3& point, TraceContext& context) const override;
    Bounds bounds() const override { return shape_->bounds(); }

  private:
    ShapePointer shape_;
};

}  // namespace isoscope
