// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/camera.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>

#include "core/scene/camera_projection.h"

namespace isoscope {

namespace {

/// Below this length of sky x direction POV-Ray takes the view as parallel to the sky.
constexpr double parallelLimit = 1e-10;

glm::dvec3 normalizedOrZero(const glm::dvec3& v) {
    const double length = glm::length(v);
    // As vectors of many are normalized: a single division.
    return length > 0 && std::isfinite(length) ? v * (1 / length) : glm::dvec3(0);
}

}  // namespace

Ray Camera::ray(double u, double v) const {
    if (!flat()) {
        const Ray ray = curvedRay(*this, u, v);
        return {ray.origin, normalizedOrZero(ray.direction)};
    }
    const glm::dvec3 offset = u * right + v * up;
    if (kind == CameraKind::orthographic) return {location + offset, normalizedOrZero(direction)};
    return {location, normalizedOrZero(direction + offset)};
}

RayBundle Camera::bundle(double lowU, double highU, double lowV, double highV) const {
    const double infinity = std::numeric_limits<double>::infinity();
    if (!flat() || blur.any() || normalTape) {
        const Bounds anywhere{glm::dvec3(-infinity), glm::dvec3(infinity)};
        return {anywhere, anywhere};
    }
    Bounds offsets{glm::dvec3(infinity), glm::dvec3(-infinity)};
    for (const double u : {lowU, highU})
        for (const double v : {lowV, highV}) {
            const glm::dvec3 offset = u * right + v * up;
            offsets = {glm::min(offsets.low, offset), glm::max(offsets.high, offset)};
        }
    const auto movedBy = [&](const glm::dvec3& by) { return Bounds{by + offsets.low, by + offsets.high}; };
    // The lengths of directions do not matter: a bundle holds its rays as far as they go.
    if (kind == CameraKind::orthographic) return {movedBy(location), {direction, direction}};
    return {{location, location}, movedBy(direction)};
}

Camera Camera::lookingAt(const glm::dvec3& target) const {
    const glm::dvec3 view = normalizedOrZero(target - location);
    if (view == glm::dvec3(0)) return *this;
    // Where they lie in one plane, POV-Ray counts it as mirrored.
    const bool mirrored = !(glm::dot(glm::cross(up, direction), right) > 0);
    // Parallel to the sky, POV-Ray falls back on the x axis and does not straighten what follows from it.
    glm::dvec3 side = glm::cross(sky, view);
    const double length = glm::length(side);
    side = length < parallelLimit ? glm::dvec3(1, 0, 0) : side / length;

    Camera turned = *this;
    turned.lookAt = target;
    turned.direction = glm::length(direction) * view;
    turned.right = (mirrored ? -glm::length(right) : glm::length(right)) * side;
    turned.up = glm::length(up) * glm::cross(view, side);
    return turned;
}

Camera Camera::withAngle(double degrees) const {
    Camera changed = *this;
    if (!flat()) {
        if (degrees > 0 && std::isfinite(degrees)) changed.angle = degrees;
        return changed;
    }
    if (!(degrees > 0 && degrees < 180)) return *this;
    const double tangent = std::tan(glm::radians(degrees) / 2);
    const double width = glm::length(right);
    if (kind == CameraKind::perspective) {
        changed.direction = normalizedOrZero(direction) * (width / (2 * tangent));
    } else if (width > 0) {
        const double factor = 2 * glm::length(lookAt - location) * tangent / width;
        changed.right = right * factor;
        changed.up = up * factor;
    }
    return changed;
}

Camera Camera::transformed(const Transform& transform) const {
    Camera changed = *this;
    changed.location = transform.point(location);
    changed.lookAt = transform.point(lookAt);
    changed.blur.focalPoint = transform.point(blur.focalPoint);
    changed.direction = transform.direction(direction);
    changed.right = transform.direction(right);
    changed.up = transform.direction(up);
    changed.sky = transform.direction(sky);
    return changed;
}

}  // namespace isoscope
