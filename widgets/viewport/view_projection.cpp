// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/view_projection.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace isoscope {

std::optional<QPointF> ViewProjection::pixelOf(const glm::dvec3& point) const {
    if (!camera_.flat()) return {};
    const glm::dmat3 axes(camera_.right, camera_.up, camera_.direction);
    const double determinant = glm::determinant(axes);
    if (!(std::abs(determinant) > 0) || !std::isfinite(determinant)) return {};
    const glm::dvec3 in = glm::inverse(axes) * (point - camera_.location);
    const bool parallel = camera_.kind == CameraKind::orthographic;
    constexpr double nearest = 1e-6;
    if (!parallel && !(in.z > nearest)) return {};
    const double scale = parallel ? 1 : 1 / in.z;
    const QPointF pixel((in.x * scale + 0.5) * size_.width(), (0.5 - in.y * scale) * size_.height());
    // Far outside, painters work on numbers that overflow.
    constexpr double farthest = 1e6;
    if (!(std::abs(pixel.x()) < farthest && std::abs(pixel.y()) < farthest)) return {};
    return pixel;
}

glm::dvec3 ViewProjection::sightTo(const glm::dvec3& point) const {
    return camera_.kind == CameraKind::orthographic ? camera_.direction : point - camera_.location;
}

glm::dvec3 ViewProjection::turned(const glm::dvec3& direction) const {
    const auto along = [&](const glm::dvec3& way) {
        const double length = glm::length(way);
        return length > 0 && std::isfinite(length) ? glm::dot(direction, way) / length : 0;
    };
    return {along(camera_.right), along(camera_.up), along(camera_.direction)};
}

Ray ViewProjection::rayAt(const QPointF& pixel) const {
    return camera_.ray(pixel.x() / size_.width() - 0.5, 0.5 - pixel.y() / size_.height());
}

}  // namespace isoscope
