// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shapes/combined/convex_solid.h"
#include "core/shapes/shape.h"

namespace isoscope {

/// The half-space of the points p with normal . p < distance |normal| (docs/povray/primitives.md, section
/// 14): `distance` is the Euclidean distance from the origin. Like POV-Ray's it is not met beyond 1e7 units
/// of length. A zero or non-finite normal makes an empty shape.
class Plane : public Shape, public ConvexSolid {
  public:
    Plane(const glm::dvec3& normal, double distance);

    /// The normal, of unit length (0 for an empty shape), and the distance as given.
    const glm::dvec3& normal() const { return normal_; }
    double distance() const { return distance_; }

    void intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const override;
    void nearest(std::span<const Ray> rays, TraceContext& context,
                 std::span<NearestHit> nearest) const override;
    void nearestInBatch(const RayBatch& rays, TraceContext& context, HitBatch& hits) const override;
    void spans(const RayBatch& rays, SpanBatch& spans) const override;
    bool contains(const glm::dvec3& point, TraceContext& context) const override;
    /// Half infinite when the normal is an axis, infinite otherwise.
    Bounds bounds() const override;
    Bounds complementWithin(const Bounds& room) const override;
    PrimitivePointer primitive() const override { return this; }
    const ConvexSolid* convexSolid() const override { return this; }

  private:
    /// Where the ray meets the plane, if it does in the interval.
    bool meet(const Ray& ray, RayInterval interval, double& t) const;

    glm::dvec3 normal_;
    double distance_;
};

}  // namespace isoscope
