// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/camera_lens.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace isoscope {

namespace {

glm::dvec3 unit(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0 ? v / length : glm::dvec3(0);
}

}  // namespace

Ray throughLens(const Camera& camera, const Ray& ray, const glm::dvec2& place) {
    if (!camera.blur.any()) return ray;
    const double depth = glm::length(camera.blur.focalPoint - camera.location);
    const double t = depth / glm::dot(ray.direction, unit(camera.direction));
    if (!(t > 0) || !std::isfinite(t)) return ray;
    const double radius = camera.blur.aperture / 4;
    const glm::dvec3 shift = radius * (place.x * unit(camera.right) + place.y * unit(camera.up));
    Ray bent = ray;
    bent.origin += shift;
    bent.direction = unit(t * ray.direction - shift);
    return bent;
}

}  // namespace isoscope
