// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/ray_bundle.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

namespace isoscope {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Cuts `range` to the t with start + t slope <= limit.
void keepBelow(double start, double slope, double limit, RayInterval& range) {
    // Widened by rounding: a ray that grazes the box must not get lost.
    const double room = limit - start + 1e-12 * (std::abs(limit) + std::abs(start));
    if (slope > 0)
        range.far = std::min(range.far, room / slope);
    else if (slope < 0)
        range.near = std::max(range.near, room / slope);
    else if (room < 0)
        range.far = -infinity;
}

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

bool RayBundle::mayMeet(const Bounds& bounds) const {
    if (!usable_) return true;
    // At t >= 0 all rays are between origins.low + t directions.low and origins.high + t directions.high.
    RayInterval range;
    for (int axis = 0; axis < 3; ++axis) {
        keepBelow(origins_.low[axis], directions_.low[axis], bounds.high[axis], range);
        keepBelow(-origins_.high[axis], -directions_.high[axis], -bounds.low[axis], range);
    }
    return range.near <= range.far * (1 + 1e-12);
}

}  // namespace isoscope
