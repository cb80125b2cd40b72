// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shapes/combined/convex_solid.h"
#include "core/shapes/shape.h"

namespace isoscope {

/// A solid ball. Like POV-Ray it takes a negative radius for its absolute value; radius 0 is met by no ray.
class Sphere : public Shape, public ConvexSolid {
  public:
    Sphere(const glm::dvec3& center, double radius);

    /// The middle as given, and the radius as its absolute value.
    const glm::dvec3& center() const { return center_; }
    double radius() const { return radius_; }

    void intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const override;
    void nearest(std::span<const Ray> rays, TraceContext& context,
                 std::span<NearestHit> nearest) const override;
    void nearestInBatch(const RayBatch& rays, TraceContext& context, HitBatch& hits) const override;
    void spans(const RayBatch& rays, SpanBatch& spans) const override;
    bool contains(const glm::dvec3& point, TraceContext& context) const override;
    Bounds bounds() const override;
    std::optional<glm::dvec2> surfacePlace(const glm::dvec3& point) const override;
    PrimitivePointer primitive() const override { return this; }
    const ConvexSolid* convexSolid() const override { return this; }

  private:
    glm::dvec3 center_;
    double radius_;
};

}  // namespace isoscope
