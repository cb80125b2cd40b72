// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/rays/ray_bundle.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace isoscope {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Comparisons leave this much room, relatively: a ray that grazes must not get lost by rounding.
constexpr double slack = 1e-12;

/// Cuts `range` to the t with start + t slope <= limit.
void keepBelow(double start, double slope, double limit, RayInterval& range) {
    const double room = limit - start + slack * (std::abs(limit) + std::abs(start));
    if (slope > 0)
        range.far = std::min(range.far, room / slope);
    else if (slope < 0)
        range.near = std::max(range.near, room / slope);
    else if (room < 0)
        range.far = -infinity;
}

glm::dvec3 middle(const Bounds& box) { return 0.5 * (box.low + box.high); }
/// Half the diagonal.
double reach(const Bounds& box) { return 0.5 * glm::length(box.high - box.low); }

}  // namespace

RayBundle::RayBundle(std::span<const Ray> rays)
    : origins_{glm::dvec3(infinity), glm::dvec3(-infinity)}, directions_(origins_) {
    glm::dvec3 poison(0);
    for (const Ray& ray : rays) {
        // 0, or NaN for what is not finite.
        poison += (ray.origin - ray.origin) + (ray.direction - ray.direction);
        origins_ = {glm::min(origins_.low, ray.origin), glm::max(origins_.high, ray.origin)};
        directions_ = {glm::min(directions_.low, ray.direction), glm::max(directions_.high, ray.direction)};
    }
    usable_ = poison == glm::dvec3(0);
}

RayBundle::RayBundle(const Bounds& origins, const Bounds& directions)
    : origins_(origins), directions_(directions), usable_(origins.finite() && directions.finite()) {}

RayBundle RayBundle::toObject(const Transform& transform) const {
    const glm::dmat4& matrix = transform.backward();
    // The direction box, moved without the translation.
    glm::dmat4 turn = matrix;
    turn[3] = glm::dvec4(0, 0, 0, 1);
    if (!usable_) return *this;
    return {isoscope::transform(origins_, matrix), isoscope::transform(directions_, turn)};
}

bool RayBundle::mayMeet(const Bounds& bounds) const {
    if (!usable_) return true;
    // At t >= 0 all rays are between origins.low + t directions.low and origins.high + t directions.high.
    RayInterval range;
    for (int axis = 0; axis < 3; ++axis) {
        keepBelow(origins_.low[axis], directions_.low[axis], bounds.high[axis], range);
        keepBelow(-origins_.high[axis], -directions_.high[axis], -bounds.low[axis], range);
    }
    return range.near <= range.far * (1 + slack);
}

bool RayBundle::mayMeetBall(const glm::dvec3& center, double radius) const {
    if (!usable_) return true;
    // A ray is never farther than spread + t widening from arm + t direction, so it misses unless
    // |arm + t direction| <= spread + radius + t widening for a t >= 0: a t^2 + 2 b t + c <= 0.
    const glm::dvec3 arm = middle(origins_) - center;
    const glm::dvec3 direction = middle(directions_);
    const double widening = reach(directions_);
    const double distance = reach(origins_) + radius + slack * (glm::length(arm) + glm::length(center));
    const double a = glm::dot(direction, direction) - widening * widening;
    const double b = glm::dot(arm, direction) - distance * widening;
    const double c = glm::dot(arm, arm) - distance * distance;
    if (!(c > 0) || !(a > 0)) return true;
    return b < 0 && b * b * (1 + slack) >= a * c;
}

}  // namespace isoscope
