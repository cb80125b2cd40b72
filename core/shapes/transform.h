// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "core/shapes/rays/ray.h"

namespace isoscope {

/// An affine map with its inverse, composed in the order the scene writes it: the map written first acts
/// first. Conventions are POV-Ray's: left-handed coordinates, angles in degrees, `rotate <a,b,c>` turns
/// about x, then y, then z.
class Transform {
  public:
    Transform() = default;

    /// p becomes p + by.
    static Transform translation(const glm::dvec3& by);
    /// Factors of 0 count as 1, as in POV-Ray.
    static Transform scaling(const glm::dvec3& factors);
    /// About x, then y, then z, or about an axis of any length; an axis of 0, or not finite, gives the
    /// identity.
    static Transform rotation(const glm::dvec3& degrees);
    static Transform axisRotation(const glm::dvec3& axis, double degrees);
    /// Column-vector form. A singular matrix gives the identity and `singular()` is true.
    static Transform matrix(const glm::dmat4& matrix);

    /// This map, then `next`.
    Transform then(const Transform& next) const;
    /// Forward and backward exchanged, without new rounding; a singular one stays so.
    Transform inverse() const;

    /// Whether the map is the identity to the bit: a turn by 360 degrees is not.
    bool identity() const;
    /// Whether a matrix without inverse was asked for here, or in a map that this one was composed of.
    bool singular() const { return singular_; }
    /// The map and its inverse in column-vector form: glm's [3] is the translation.
    const glm::dmat4& forward() const { return forward_; }
    const glm::dmat4& backward() const { return backward_; }

    /// Points are moved, directions are not; neither is normalised.
    glm::dvec3 point(const glm::dvec3& p) const { return moved(forward_, p); }
    /// What the map takes to `p`.
    glm::dvec3 inversePoint(const glm::dvec3& p) const { return moved(backward_, p); }
    glm::dvec3 direction(const glm::dvec3& d) const { return turned(forward_, d); }
    /// A surface normal, carried by the inverse transpose; not normalised.
    glm::dvec3 normal(const glm::dvec3& n) const {
        const auto along = [&](int k) {
            return backward_[k][0] * n.x + backward_[k][1] * n.y + backward_[k][2] * n.z;
        };
        return {along(0), along(1), along(2)};
    }
    /// The ray in the object's own coordinates; t keeps its meaning.
    Ray toObject(const Ray& ray) const {
        return {moved(backward_, ray.origin), turned(backward_, ray.direction), ray.sample};
    }

  private:
    // As the product of matrix and vector, without the row that is not needed.
    static glm::dvec3 moved(const glm::dmat4& m, const glm::dvec3& p) {
        const auto row = [&](int k) { return (m[0][k] * p.x + m[1][k] * p.y) + (m[2][k] * p.z + m[3][k]); };
        return {row(0), row(1), row(2)};
    }
    static glm::dvec3 turned(const glm::dmat4& m, const glm::dvec3& d) {
        const auto row = [&](int k) { return (m[0][k] * d.x + m[1][k] * d.y) + m[2][k] * d.z; };
        return {row(0), row(1), row(2)};
    }

    glm::dmat4 forward_{1};
    glm::dmat4 backward_{1};
    bool singular_ = false;
};

}  // namespace isoscope
