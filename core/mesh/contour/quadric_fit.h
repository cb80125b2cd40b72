// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>
#include <vector>

namespace isoscope {

/// Finds the point that is nearest to a number of tangent planes, by least squares: on a smooth surface a
/// point near their places, at a sharp edge or corner a point of it. Where planes say little, the mean of
/// their places counts. After Garland and Heckbert, "Surface simplification using quadric error metrics"
/// (1997), and Ju, Losasso, Schaefer and Warren, "Dual contouring of Hermite data" (2002).
class QuadricFit {
  public:
    /// Forgets all planes.
    void clear() { planes_.clear(); }
    /// A plane through `place` with a normal of unit length.
    void add(const glm::dvec3& place, const glm::dvec3& normal) { planes_.push_back({place, normal}); }

    /// How many were added.
    std::size_t planes() const { return planes_.size(); }
    /// The mean of the places; there must be some.
    glm::dvec3 middle() const;
    /// The mean of the normals, unit length; the first one where they cancel out.
    glm::dvec3 meanNormal() const;
    /// The least cosine between meanNormal() and a normal.
    double leastCosine() const;
    /// The point, in the box: what lies outside is cut off on the way from the middle.
    glm::dvec3 solve(const glm::dvec3& low, const glm::dvec3& high) const;
    /// How far a point is from the farthest plane.
    double distance(const glm::dvec3& point) const;

  private:
    struct Plane {
        glm::dvec3 place, normal;
    };
    std::vector<Plane> planes_;
};

}  // namespace isoscope
