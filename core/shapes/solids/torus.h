// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/roots/polynomial/root_choice.h"
#include "core/shapes/shape.h"

namespace isoscope {

/// (sqrt(x^2 + z^2) - major)^2 + y^2 < minor^2 (docs/povray/primitives.md, section 3). Where minor is greater
/// than major the inner leaf of the quartic is met too, as in POV-Ray.
class Torus : public Shape {
  public:
    Torus(double major, double minor, RootChoice choice = RootChoice::isolation);

    /// The radius of the circle in the x-z plane and that of the tube around it, as absolute values.
    double major() const { return major_; }
    double minor() const { return minor_; }

    void intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const override;
    bool contains(const glm::dvec3& point, TraceContext& context) const override;
    Bounds bounds() const override;
    std::optional<glm::dvec2> surfacePlace(const glm::dvec3& point) const override;
    PrimitivePointer primitive() const override { return this; }

  private:
    glm::dvec3 normalAt(const glm::dvec3& point) const;

    double major_;
    double minor_;
    RootChoice choice_;
};

}  // namespace isoscope
