// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/orbit_view.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace isoscope {

std::array<glm::dvec3*, 7> movableVectors(Camera& camera) {
    return {&camera.location, &camera.direction, &camera.right,          &camera.up,
            &camera.sky,      &camera.lookAt,    &camera.blur.focalPoint};
}

namespace {

/// How near to the sky's axis the view may come.
constexpr double poleMargin = 1;
constexpr double shortestDistance = 1e-6;
constexpr double longestDistance = 1e9;

/// Where the camera looks: look_at where it lies ahead, else (no look_at, or behind) the origin, else one
/// unit ahead.
double distanceAhead(const Camera& camera, const glm::dvec3& view) {
    for (const glm::dvec3& target : {camera.lookAt, glm::dvec3(0)}) {
        const double ahead = glm::dot(target - camera.location, view);
        if (ahead > shortestDistance && ahead < longestDistance) return ahead;
    }
    return 1;
}

bool mirrored(const Camera& camera) {
    return glm::dot(glm::cross(camera.up, camera.direction), camera.right) < 0;
}

}  // namespace

void OrbitView::setHome(const Camera& home) {
    home_ = home;
    show(home);
}

void OrbitView::show(const Camera& camera) {
    camera_ = camera;
    const double length = glm::length(camera.direction);
    const glm::dvec3 view = length > 0 ? camera.direction / length : glm::dvec3(0, 0, 1);
    pivot_ = camera.location + distanceAhead(camera, view) * view;
}

double OrbitView::distance() const { return glm::length(pivot_ - camera_.location); }

void OrbitView::orbit(double degreesRight, double degreesUp) {
    const double skyLength = glm::length(camera_.sky);
    const double viewLength = glm::length(camera_.direction);
    if (!std::isfinite(degreesRight) || !std::isfinite(degreesUp)) return;
    if (!(skyLength > 0) || !(viewLength > 0) || (degreesRight == 0 && degreesUp == 0)) return;
    const glm::dvec3 sky = camera_.sky / skyLength;
    const double sign = mirrored(camera_) ? -1 : 1;
    turn(sky, sign * degreesRight);

    // Elevation of the camera above the pivot; moving the picture up lowers the camera.
    const glm::dvec3 view = camera_.direction / viewLength;
    glm::dvec3 level = glm::cross(sky, view);
    if (glm::length(level) < 1e-9) level = sign * camera_.right;
    const double elevation = glm::degrees(std::asin(std::clamp(-glm::dot(view, sky), -1.0, 1.0)));
    const double upright = glm::dot(camera_.up, sky) < 0 ? -1 : 1;
    const double limit = std::max(90 - poleMargin, std::abs(elevation));
    const double wanted = std::clamp(elevation - upright * degreesUp, -limit, limit);
    turn(level, wanted - elevation);
    camera_.lookAt = pivot_;
}

void OrbitView::turn(const glm::dvec3& axis, double degrees) {
    const Transform turning = Transform::translation(-pivot_)
                                  .then(Transform::axisRotation(axis, degrees))
                                  .then(Transform::translation(pivot_));
    camera_ = camera_.transformed(turning);
    camera_.sky = home_.sky;
}

void OrbitView::pan(double widths, double heights) {
    if (!std::isfinite(widths) || !std::isfinite(heights)) return;
    const double scale = camera_.kind == CameraKind::orthographic
                             ? 1
                             : distance() / std::max(glm::length(camera_.direction), 1e-300);
    const glm::dvec3 shift = -scale * (widths * camera_.right + heights * camera_.up);
    const glm::dvec3 location = camera_.location + shift;
    if (!(glm::length(location) < longestDistance)) return;
    camera_.location = location;
    pivot_ += shift;
    camera_.lookAt = pivot_;
}

void OrbitView::zoom(double factor) {
    if (!std::isfinite(factor) || !(factor > 0)) return;
    if (camera_.kind == CameraKind::orthographic) {
        const double width = glm::length(camera_.right);
        const double wanted = std::clamp(width / factor, shortestDistance, longestDistance);
        if (!(width > 0)) return;
        camera_.right *= wanted / width;
        camera_.up *= wanted / width;
        return;
    }
    const double now = distance();
    const double wanted = std::clamp(now / factor, shortestDistance, longestDistance);
    camera_.location = pivot_ + (wanted / now) * (camera_.location - pivot_);
    camera_.lookAt = pivot_;
}

}  // namespace isoscope
