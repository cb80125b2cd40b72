// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <limits>

namespace isoscope {

/// The boxes around the origins and the directions of some lines, and around their intervals; as large as
/// nothing where there is no line.
struct LineExtents {
    static constexpr double infinity = std::numeric_limits<double>::infinity();

    glm::dvec3 lowOrigin{infinity}, highOrigin{-infinity};
    glm::dvec3 lowDirection{infinity}, highDirection{-infinity};
    double near = infinity, far = -infinity;

    void add(const LineExtents& other) {
        lowOrigin = glm::min(lowOrigin, other.lowOrigin);
        highOrigin = glm::max(highOrigin, other.highOrigin);
        lowDirection = glm::min(lowDirection, other.lowDirection);
        highDirection = glm::max(highDirection, other.highDirection);
        near = glm::min(near, other.near), far = glm::max(far, other.far);
    }
};

}  // namespace isoscope
