// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shapes/combined/convex_solid.h"
#include "core/shapes/shape.h"

namespace isoscope {

/// A solid box with its edges along the axes; swapped corners are sorted.
class Box : public Shape, public ConvexSolid {
  public:
    Box(const glm::dvec3& low, const glm::dvec3& high);

    /// Opposite corners, low <= high on every axis whatever the order in which they were given.
    const glm::dvec3& low() const { return low_; }
    const glm::dvec3& high() const { return high_; }

    void intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const override;
    void nearestInBatch(const RayBatch& rays, TraceContext& context, HitBatch& hits) const override;
    void spans(const RayBatch& rays, SpanBatch& spans) const override;
    bool contains(const glm::dvec3& point, TraceContext& context) const override;
    Bounds bounds() const override { return {low_, high_}; }
    std::optional<glm::dvec2> surfacePlace(const glm::dvec3& point) const override;
    PrimitivePointer primitive() const override { return this; }
    const ConvexSolid* convexSolid() const override { return isEmpty() ? nullptr : this; }

  private:
    bool isEmpty() const { return !(low_.x <= high_.x && low_.y <= high_.y && low_.z <= high_.z); }

    glm::dvec3 low_;
    glm::dvec3 high_;
};

}  // namespace isoscope
