// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/camera_projection.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>
#include <optional>

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

/// A place in a round picture: it shows what lies `angle` away from straight ahead, towards the point (x, y)
/// of the picture, `radius` away from its middle.
struct RoundPlace {
    double angle, x, y, radius;
};

/// The axes of the camera without their lengths.
struct Axes {
    explicit Axes(const Camera& camera)
        : right(unit(camera.right)), up(unit(camera.up)), ahead(unit(camera.direction)) {}

    glm::dvec3 away(const RoundPlace& place) const {
        const auto [angle, x, y, radius] = place;
        if (!(radius > 0)) return ahead;
        return std::sin(angle) / radius * (x * right + y * up) + std::cos(angle) * ahead;
    }
    /// Turned to the right, and up, each in its own plane.
    glm::dvec3 aside(double angle) const { return std::sin(angle) * right + std::cos(angle) * ahead; }
    glm::dvec3 upwards(double angle) const { return std::sin(angle) * up + std::cos(angle) * ahead; }

    glm::dvec3 right, up, ahead;
};

/// Equal steps in the picture are equal angles.
std::optional<RoundPlace> fisheye(const Camera& camera, double u, double v) {
    const double x = 2 * u * glm::length(camera.right), y = 2 * v * glm::length(camera.up);
    const double radius = std::hypot(x, y);
    if (radius > 1) return std::nullopt;
    return RoundPlace{radius * glm::radians(camera.angle) / 2, x, y, radius};
}

/// Of ultra_wide_angle, how far a place lies to the side and up, as angles.
glm::dvec2 wideAngles(const Camera& camera, double u, double v) {
    const double angle = glm::radians(camera.angle);
    return {u * angle, v * angle * glm::length(camera.up) / glm::length(camera.right)};
}

glm::dvec3 ultraWideAngle(const Camera& camera, double u, double v) {
    const Axes axes(camera);
    const glm::dvec2 angles = wideAngles(camera, u, v);
    return std::sin(angles.x) * axes.right + std::sin(angles.y) * axes.up +
           std::cos(angles.x) * std::cos(angles.y) * axes.ahead;
}

/// The projection onto a dome. The curve from the radius in the picture to the angle is that of the Omnimax
/// lens (Nelson Max, "Computer graphics distortion for IMAX and OMNIMAX projection", 1983). Wide pictures are
/// cut below, where the dome ends in a plane inclined by 45 degrees.
std::optional<RoundPlace> omnimax(const Camera& camera, double u, double v) {
    constexpr double widest = 1.283458;
    const double aspect = glm::length(camera.right) / glm::length(camera.up);
    double x = 2 * u, y = 2 * v / aspect;
    if (aspect > 1) {
        const double scale = std::min(aspect, widest);
        x = 2 * u * aspect / scale;
        y = 1 + (2 * v - 1) / scale;
    }
    const double radius = std::hypot(x, y);
    if (!(radius <= 1)) return std::nullopt;
    const double square = radius * radius;
    const double angle = radius * (1.411269 + square * (-0.09439 + square * 0.25674));
    if (radius > 0 && std::sin(angle) * y / radius < -std::cos(angle)) return std::nullopt;
    return RoundPlace{angle, x, y, radius};
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

std::optional<RoundPlace> roundPlace(const Camera& camera, double u, double v) {
    return camera.kind == CameraKind::fisheye ? fisheye(camera, u, v) : omnimax(camera, u, v);
}

}  // namespace

Ray curvedRay(const Camera& camera, double u, double v) {
    const double angle = glm::radians(camera.angle);
    const glm::dvec3& from = camera.location;
    switch (camera.kind) {
        case CameraKind::fisheye:
        case CameraKind::omnimax: {
            const std::optional<RoundPlace> place = roundPlace(camera, u, v);
            return {from, place ? Axes(camera).away(*place) : nowhere};
        }
        case CameraKind::ultraWideAngle: return {from, ultraWideAngle(camera, u, v)};
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

glm::dvec2 normalPlace(const Camera& camera, double u, double v) {
    const double angle = glm::radians(camera.angle), pi = std::numbers::pi;
    const double right = u * glm::length(camera.right), up = v * glm::length(camera.up);
    switch (camera.kind) {
        case CameraKind::fisheye:
        case CameraKind::omnimax: {
            const std::optional<RoundPlace> place = roundPlace(camera, u, v);
            if (!place || !(place->radius > 0)) return glm::dvec2(0);
            const double raised = std::asin(std::clamp(place->y / place->radius, -1.0, 1.0));
            return {place->x < 0 ? pi - raised : raised, place->angle};
        }
        case CameraKind::ultraWideAngle: return wideAngles(camera, u, v);
        case CameraKind::panoramic: return {pi / 2 - u * pi, v * pi};
        case CameraKind::spherical: return {u * angle, v * glm::radians(camera.verticalAngle)};
        case CameraKind::uprightCylinder:
        case CameraKind::movingUprightCylinder: return {u * angle, up};
        case CameraKind::lyingCylinder:
        case CameraKind::movingLyingCylinder: return {right, v * angle};
        case CameraKind::perspective:
        case CameraKind::orthographic: break;
    }
    return {u, v};
}

}  // namespace isoscope
