// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <limits>

#include "core/shapes/rays/ray.h"

namespace isoscope {

/// An axis-parallel box, corners included; may be infinite. Empty when low > high on an axis.
struct Bounds {
    glm::dvec3 low{-std::numeric_limits<double>::infinity()};
    glm::dvec3 high{std::numeric_limits<double>::infinity()};

    /// Whether all six ends are; an empty box may be finite, too.
    bool finite() const;
    /// Borders count as inside. False for a point with a NaN.
    bool contains(const glm::dvec3& point) const;
    /// The part of the ray inside the box, cut to t >= 0.
    RayInterval clip(const Ray& ray) const;
};

/// The smallest box around both; an empty one adds nothing.
Bounds unite(const Bounds& a, const Bounds& b);
/// What both share: empty, with low > high on an axis, where they do not meet.
Bounds intersect(const Bounds& a, const Bounds& b);
/// The box around the transformed corners; an infinite box stays infinite.
Bounds transform(const Bounds& bounds, const glm::dmat4& matrix);
/// The box around the image, side by side: a side stays finite when what it depends on is.
Bounds image(const Bounds& bounds, const glm::dmat4& matrix);
/// A little larger than `bounds`, which rounding may have left too small.
Bounds grown(const Bounds& bounds);

}  // namespace isoscope
