// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <glm/geometric.hpp>

#include "core/shapes/rays/ray.h"

namespace isoscope {

/// A ray with its line measured from the point nearest to `center`, in units of length. Polynomials along it
/// have small coefficients wherever the ray began, so that far rays lose no digits.
struct CenteredRay {
    glm::dvec3 origin{0};     ///< relative to the center; at right angles to the direction but for rounding
    glm::dvec3 direction{0};  ///< unit length
    double middle = 0;        ///< the ray's t of the new origin
    double speed = 0;         ///< length of the ray's direction
    bool usable = false;      ///< false for a direction of 0 and numbers that are not finite

    CenteredRay(const Ray& ray, const glm::dvec3& center) {
        speed = glm::length(ray.direction);
        if (!(speed > 0) || !std::isfinite(speed)) return;
        direction = ray.direction / speed;
        const glm::dvec3 arm = ray.origin - center;
        middle = -glm::dot(arm, direction) / speed;
        origin = arm + (middle * speed) * direction;
        usable = std::isfinite(middle) && std::isfinite(glm::dot(origin, origin));
    }

    /// The ray's t of the place at distance s behind the new origin, and back.
    double toRay(double s) const { return middle + s / speed; }
    double fromRay(double t) const { return (t - middle) * speed; }
    /// The place at distance s, relative to the center.
    glm::dvec3 at(double s) const { return origin + s * direction; }
};

/// POV-Ray meets nothing farther than this many units of length from the ray's origin.
constexpr double farthestDistance = 1e7;

}  // namespace isoscope
