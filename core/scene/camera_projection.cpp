// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/camera_projection.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

namespace isoscope {

namespace {

constexpr glm::dvec3 nowhere{0};

glm::dvec3 unit(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0 ? v / length : nowhere;
}

/// `v` turned about `axis` by an angle in radians (Rodrigues' formula).
glm::dvec3 turned(const glm::dvec3& v, const glm::dvec3& axis, double angle) {
    const glm::dvec3 k = unit(axis);
    return std::cos(angle) * v + std::sin(angle) * glm::cross(k, v) +
           (1 - std::cos(angle)) * glm::dot(k, v) * k;
}

/// The axes of the camera without their lengths.
struct Axes {
    explicit Axes(const Camera& camera)
        : right(unit(camera.right)), up(unit(camera.up)), ahead(unit(camera.direction)) {}

    /// `angle` away from straight ahead, towards the point (x, y) of the picture, `radius` away from its
    /// middle.
    glm::dvec3 away(double angle, double x, double y, double radius) const {
        if (!(radius > 0)) return ahead;
        return std::sin(angle) / radius * (x * right + y * up) + std::cos(angle) * ahead;
    }
    /// Turned to the right, and up, each in its own plane.
    glm::dvec3 aside(double angle) const { return std::sin(angle) * right + std::cos(angle) * ahead; }
    glm::dvec3 upwards(double angle) const { return std::sin(angle) * up + std::cos(angle) * ahead; }

    glm::dvec3 right, up, ahead;
};

/// Equal steps in the picture are equal angles.
glm::dvec3 fisheye(const Camera& camera, double u, double v) {
    const double x = 2 * u * glm::length(camera.right), y = 2 * v * glm::length(camera.up);
    const double radius = std::hypot(x, y);
    if (radius > 1) return nowhere;
    return Axes(camera).away(radius * glm::radians(camera.angle) / 2, x, y, radius);
}

glm::dvec3 ultraWideAngle(const Camera& camera, double u, double v) {
    const Axes axes(camera);
    const double sideways = u * glm::radians(camera.angle);
    const double upwards =
        v * glm::radians(camera.angle) * glm::length(camera.up) / glm::length(camera.right);
    return std::sin(sideways) * axes.right + std::sin(upwards) * axes.up +
           std::cos(sideways) * std::cos(upwards) * axes.ahead;
}

/// The projection onto a dome. The curve from the radius in the picture to the angle is that of the Omnimax
/// lens (Nelson Max, "Computer graphics distortion for IMAX and OMNIMAX projection", 1983). Wide pictures are
/// cut below, where the dome ends in a plane inclined by 45 degrees.
glm::dvec3 omnimax(const Camera& camera, double u, double v) {
    constexpr double widest = 1.283458;
    const double aspect = glm::length(camera.right) / glm::length(camera.up);
    double x = 2 * u, y = 2 * v / aspect;
    if (aspect > 1) {
        const double scale = std::min(aspect, widest);
        x = 2 * u * aspect / scale;
        y = 1 + (2 * v - 1) / scale;
    }
    const double radius = std::hypot(x, y);
    if (!(radius <= 1)) return nowhere;
    const double square = radius * radius;
    const double angle = radius * (1.411269 + square * (-0.09439 + square * 0.25674));
    if (radius > 0 && std::sin(angle) * y / radius < -std::cos(angle)) return nowhere;
    return Axes(camera).away(angle, x, y, radius);
}

/// Half around horizontally; vertically as far as the eye can reach.
glm::dvec3 panoramic(const Camera& camera, double u, double v) {
    const double pi = std::numbers::pi;
    return std::sin(u * pi) * camera.right + std::tan(v * pi) * camera.up +
           std::cos(u * pi) * camera.direction;
}

glm::dvec3 spherical(const Camera& camera, double u, double v) {
    const glm::dvec3 raised =
        turned(unit(camera.direction), camera.right, -v * glm::radians(camera.verticalAngle));
    return turned(raised, camera.up, u * glm::radians(camera.angle));
}

}  // namespace

Ray curvedRay(const Camera& camera, double u, double v) {
    const double angle = glm::radians(camera.angle);
    const glm::dvec3& from = camera.location;
    switch (camera.kind) {
        case CameraKind::fisheye: return {from, fisheye(camera, u, v)};
        case CameraKind::ultraWideAngle: return {from, ultraWideAngle(camera, u, v)};
        case CameraKind::omnimax: return {from, omnimax(camera, u, v)};
        case CameraKind::panoramic: return {from, panoramic(camera, u, v)};
        case CameraKind::spherical: return {from, spherical(camera, u, v)};
        case CameraKind::uprightCylinder: return {from, Axes(camera).aside(u * angle) + v * camera.up};
        case CameraKind::lyingCylinder: return {from, Axes(camera).upwards(v * angle) + u * camera.right};
        case CameraKind::movingUprightCylinder: return {from + v * camera.up, Axes(camera).aside(u * angle)};
        case CameraKind::movingLyingCylinder:
            return {from + u * camera.right, Axes(camera).upwards(v * angle)};
        case CameraKind::perspective:
        case CameraKind::orthographic: break;
    }
    return {from, nowhere};
}

}  // namespace isoscope
