// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shapes/combined/convex_solid.h"
#include "core/shapes/rays/centered_ray.h"
#include "core/shapes/rays/solid_lanes.h"
#include "core/shapes/shape.h"

namespace isoscope {

/// A cone, a frustum or, with equal radii, a cylinder: the radius changes evenly along the axis; flat discs
/// close the ends unless it is open. Radii count as their absolute values. Equal end points make an empty
/// shape.
class Cone : public Shape, public ConvexSolid {
  public:
    Cone(const glm::dvec3& base, double baseRadius, const glm::dvec3& cap, double capRadius, bool open);

    /// Middles of the ends, to rounding as given; both are the middle between them for a shape that is empty.
    glm::dvec3 base() const { return center_ - half_ * axis_; }
    glm::dvec3 cap() const { return center_ + half_ * axis_; }
    /// As absolute values; `open` says that the discs at the ends are missing.
    double baseRadius() const { return baseRadius_; }
    double capRadius() const { return capRadius_; }
    bool open() const { return open_; }

    void intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const override;
    void nearestInBatch(const RayBatch& rays, TraceContext& context, HitBatch& hits) const override;
    void spans(const RayBatch& rays, SpanBatch& spans) const override;
    /// Whether caps are drawn or not.
    bool contains(const glm::dvec3& point, TraceContext& context) const override;
    Bounds bounds() const override;
    PrimitivePointer primitive() const override { return this; }
    const ConvexSolid* convexSolid() const override { return !open_ && half_ > 0 ? this : nullptr; }

  private:
    ConeForm form() const;
    void addSide(const Ray& ray, const CenteredRay& line, RayInterval interval, HitList& hits) const;
    void addCap(const Ray& ray, const CenteredRay& line, double end, RayInterval interval,
                HitList& hits) const;
    double radiusAt(double height) const { return middleRadius_ + slope_ * height; }

    glm::dvec3 center_;
    glm::dvec3 axis_{0};
    double half_ = 0;  ///< of the length; heights are measured from the center
    double middleRadius_ = 0;
    double slope_ = 0;
    double baseRadius_;
    double capRadius_;
    bool open_;
};

}  // namespace isoscope
