// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/view/fitted_view.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace isoscope {

namespace {

/// What is smaller counts as so large, in parts of its distance from the origin: a camera cannot stand in the
/// point that it looks at.
constexpr double smallest = 1e-6;
/// A camera with a curved picture sees a ball within this angle of its axis, at most.
constexpr double widestHalfAngle = 40;

/// How far the surfaces reach against and along an edge of the picture, in multiples of it.
struct Extent {
    double low, high;

    double middle() const { return 0.5 * (high - low); }
    double size() const { return std::max(high + low, smallest * (1 + std::abs(middle()))); }
};

/// Between the two planes that bound what may be seen to both sides of `side`. They hold `other` and lean by
/// `slant` edges in the length of `view` from it; each is measured where it meets the plane of `side` and
/// `other` through the origin.
Extent extentOf(SurfaceBounds& surfaces, const glm::dvec3& view, const glm::dvec3& side,
                const glm::dvec3& other, double slant) {
    const auto reach = [&](double sign) {
        glm::dvec3 normal = glm::cross(other, view + sign * slant * side);
        const double along = glm::dot(normal, sign * side);
        normal /= along;  // so that a step of `side` counts 1
        return surfaces.reach(normal);
    };
    return {reach(-1), reach(1)};
}

Camera lookingAtDepth(Camera camera, const glm::dvec3& location, const Extent& depth) {
    camera.location = location;
    const double ahead = 0.5 * (depth.high - depth.low) - glm::dot(location, camera.direction);
    camera.lookAt = location + camera.direction * (ahead / glm::dot(camera.direction, camera.direction));
    return camera;
}

Camera steppedBack(const Camera& camera, const Bounds& box, const Extent& depth, double share) {
    const glm::dvec3 center = 0.5 * (box.low + box.high);
    const double radius = std::max(0.5 * glm::length(box.high - box.low), smallest);
    const double half = std::clamp(share * 0.5 * camera.angle, 1.0, widestHalfAngle);
    const double distance = radius / std::sin(glm::radians(half));
    return lookingAtDepth(camera, center - distance * glm::normalize(camera.direction), depth);
}

}  // namespace

std::optional<Camera> fittedView(const Camera& camera, const Camera& seen, SurfaceBounds& surfaces,
                                 double share) {
    const glm::dvec3 view = seen.direction, right = seen.right, up = seen.up;
    const double volume = glm::dot(glm::cross(up, view), right);
    if (!(std::abs(volume) > 0) || !std::isfinite(volume)) return std::nullopt;
    const Bounds box = surfaces.box();
    if (isEmpty(box) || !box.finite()) return std::nullopt;
    const Extent depth{surfaces.reach(-view), surfaces.reach(view)};
    if (!seen.flat()) return steppedBack(camera, box, depth, share);

    const bool parallel = seen.kind == CameraKind::orthographic;
    const double slant = parallel ? 0 : 0.5 * share;
    const Extent across = extentOf(surfaces, view, right, up, slant);
    const Extent upwards = extentOf(surfaces, view, up, right, slant);
    const double size = std::max(across.size(), upwards.size());
    const glm::dvec3 sideways = across.middle() * right + upwards.middle() * up;
    if (!parallel) return lookingAtDepth(camera, sideways - (size / share) * view, depth);
    Camera fitted = camera;
    fitted.right *= size / share;
    fitted.up *= size / share;
    // In front of everything by as much as it is deep.
    const double place = -depth.low - depth.size() - glm::dot(sideways, view);
    return lookingAtDepth(fitted, sideways + view * (place / glm::dot(view, view)), depth);
}

Camera turnedToFace(const Camera& camera, const Bounds& box) {
    const glm::dvec3 size = box.high - box.low;
    // What is seen of a box along d is the sum of its sides' areas times |d|.
    glm::dvec3 sides{size.y * size.z, size.z * size.x, size.x * size.y};
    if (!box.finite() || isEmpty(box) || !(glm::length(sides) > 0)) return camera;
    sides = glm::normalize(sides);
    const glm::dvec3 own = glm::normalize(camera.direction);
    for (int k = 0; k < 3; ++k) sides[k] = std::copysign(sides[k], own[k]);
    return camera.lookingAt(camera.location + own + sides);
}

Camera turnedTo(const Camera& camera, StandardView view) {
    const glm::dvec3 size = glm::abs(camera.sky);
    const int upAxis = size.z > size.y && size.z >= size.x ? 2 : size.x > size.y ? 0 : 1;
    glm::dvec3 up(0), ahead(0), right(0);
    up[upAxis] = camera.sky[upAxis] < 0 ? -1 : 1;
    // POV-Ray's usual axes, and those of scenes whose sky is z.
    ahead[upAxis == 2 ? 1 : 2] = 1;
    right[upAxis == 0 ? 1 : 0] = 1;
    Camera turned = camera;
    turned.sky = view == StandardView::top ? ahead : up;
    const glm::dvec3 direction = view == StandardView::front ? ahead
                                 : view == StandardView::top ? -up
                                                             : -right;
    turned = turned.lookingAt(camera.location + direction);
    turned.sky = camera.sky;
    return turned;
}

}  // namespace isoscope
