// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "core/shapes/ray.h"

namespace isoscope {

/// An affine map with its inverse, composed in the order the scene writes it: the map written first acts
/// first. Conventions are POV-Ray's: left-handed coordinates, angles in degrees, `rotate <a,b,c>` turns
/// about x, then y, then z.
class Transform {
  public:
    Transform() = default;

    static Transform translation(const glm::dvec3& by);
    /// Factors of 0 count as 1, as in POV-Ray.
    static Transform scaling(const glm::dvec3& factors);
    static Transform rotation(const glm::dvec3& degrees);
    static Transform axisRotation(const glm::dvec3& axis, double degrees);
    /// Column-vector form. A singular matrix gives the identity and `singular()` is true.
    static Transform matrix(const glm::dmat4& matrix);

    /// This map, then `next`.
    Transform then(const Transform& next) const;
    Transform inverse() const;

    bool identity() const;
    bool singular() const { return singular_; }
    const glm::dmat4& forward() const { return forward_; }
    const glm::dmat4& backward() const { return backward_; }

    glm::dvec3 point(const glm::dvec3& p) const;
    /// What the map takes to `p`.
    glm::dvec3 inversePoint(const glm::dvec3& p) const;
    glm::dvec3 direction(const glm::dvec3& d) const;
    /// A surface normal, carried by the inverse transpose; not normalised.
    glm::dvec3 normal(const glm::dvec3& n) const;
    /// The ray in the object's own coordinates; t keeps its meaning.
    Ray toObject(const Ray& ray) const;

  private:
    glm::dmat4 forward_{1};
    glm::dmat4 backward_{1};
    bool singular_ = false;
};

}  // namespace isoscope
