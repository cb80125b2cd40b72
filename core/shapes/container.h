// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <variant>
#include <vector>

#include "core/shapes/ray.h"

namespace isoscope {

struct ContainerBox {
    glm::dvec3 low{-1};
    glm::dvec3 high{1};
};
struct ContainerSphere {
    glm::dvec3 center{0};
    double radius = 1;
};
/// Where the function of an isosurface is looked at.
using Container = std::variant<ContainerBox, ContainerSphere>;

/// Where the lines of many rays pass a container. Keeps its memory from call to call.
class ContainerPassages {
  public:
    /// The answers are those of sphereRange() and boxRange() (line_interval.h), bit for bit.
    void find(const Container& container, std::span<const Ray> rays);

    /// Where the line of ray i is inside.
    RayInterval range(std::size_t i) const { return {near_[i], far_[i]}; }
    /// The container's outward normal where the line of `ray`, number i, enters or leaves.
    glm::dvec3 wallNormal(const Container& container, const Ray& ray, std::size_t i, bool entering) const;

  private:
    std::vector<double> near_, far_;
    std::vector<double> nearAxis_, farAxis_;  ///< of a box: across whose face
};

}  // namespace isoscope
