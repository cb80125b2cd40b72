// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>

namespace isoscope {

/// The points origin + t direction, t >= 0. The direction need not have unit length: t is in units of it.
struct Ray {
    glm::dvec3 origin{0};
    glm::dvec3 direction{0, 0, 1};
    /// Which entry of TraceContext::verdicts hears what is certain about this ray; noSample: none.
    std::uint32_t sample = noSample;

    static constexpr std::uint32_t noSample = 0xffffffff;

    /// The point origin + t direction, for negative t as well.
    glm::dvec3 at(double t) const { return origin + t * direction; }
};

/// A closed interval of ray parameters; empty when near > far.
struct RayInterval {
    double near = 0;
    double far = std::numeric_limits<double>::infinity();

    /// Whether no t lies in it, which a NaN at either end makes so, too.
    bool empty() const { return !(near <= far); }
};

}  // namespace isoscope
