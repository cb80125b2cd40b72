// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shapes/shape.h"

namespace isoscope {

/// A flat disc, perhaps with a hole. As in POV-Ray the whole half-space that its normal points away from
/// counts as its inside. A normal of 0 makes an empty shape.
class Disc : public Shape {
  public:
    Disc(const glm::dvec3& center, const glm::dvec3& normal, double radius, double holeRadius = 0);

    /// The middle, the normal of unit length (0 for an empty shape), and radii as absolute values.
    const glm::dvec3& center() const { return center_; }
    const glm::dvec3& normal() const { return normal_; }
    double radius() const { return radius_; }
    double holeRadius() const { return holeRadius_; }

    void intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const override;
    bool contains(const glm::dvec3& point, TraceContext& context) const override;
    /// POV-Ray's: of the square around the disc whose sides come from the axes of x and y by the shortest
    /// turn of the z axis to the normal, 0.002 thick. It cuts intersections off.
    Bounds bounds() const override;
    Bounds boundsWithin(const Bounds& room) const override;
    PrimitivePointer primitive() const override { return this; }

  private:
    glm::dvec3 center_;
    glm::dvec3 normal_{0};
    double radius_;
    double holeRadius_;
};

}  // namespace isoscope
