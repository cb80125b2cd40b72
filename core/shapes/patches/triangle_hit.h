// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "core/shapes/rays/ray.h"

namespace isoscope {

/// Where a line meets a triangle: its t and the shares of the corners, which add up to 1.
struct TriangleHit {
    double t = 0;
    glm::dvec3 shares{0};
};

/// The directions of a ray put in the order that triangleHit() wants, so that many triangles share the work.
class TriangleLine {
  public:
    explicit TriangleLine(const Ray& ray);

    /// Of two triangles with a common edge a ray through it meets at least one: no gaps between the triangles
    /// of a mesh (Woop, Benthin and Wald, "Watertight ray/triangle intersection", 2013). Any t, negative ones
    /// too. Nothing for triangles seen edge on.
    std::optional<TriangleHit> meet(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) const;

  private:
    glm::dvec3 origin_;
    int x_ = 0, y_ = 1, z_ = 2;
    double shearX_ = 0, shearY_ = 0, scale_ = 0;
    bool usable_ = false;
};

}  // namespace isoscope
