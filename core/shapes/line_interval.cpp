// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/line_interval.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/shapes/hit_list.h"

namespace isoscope {

LineInterval sphereInterval(const Ray& ray, const glm::dvec3& center, double radius) {
    LineInterval result;
    const double squaredSpeed = glm::dot(ray.direction, ray.direction);
    if (!(squaredSpeed > 0)) return result;
    // The half chord from the point of closest approach: no cancellation for far origins.
    const glm::dvec3 arm = ray.origin - center;
    const double middle = -glm::dot(arm, ray.direction) / squaredSpeed;
    const glm::dvec3 across = arm + middle * ray.direction;
    const double squaredChord = (radius * radius - glm::dot(across, across)) / squaredSpeed;
    if (!(squaredChord > 0)) return result;
    const double half = std::sqrt(squaredChord);
    if (!std::isfinite(middle) || !std::isfinite(half)) return result;
    result.range = {middle - half, middle + half};
    result.nearNormal = unitNormal(across - half * ray.direction);
    result.farNormal = unitNormal(across + half * ray.direction);
    return result;
}

LineInterval boxInterval(const Ray& ray, const glm::dvec3& low, const glm::dvec3& high) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const LineInterval nothing;
    LineInterval result;
    result.range = {-infinity, infinity};
    for (int axis = 0; axis < 3; ++axis) {
        const double origin = ray.origin[axis];
        const double direction = ray.direction[axis];
        if (!std::isfinite(origin) || !std::isfinite(direction) || !(low[axis] <= high[axis])) return nothing;
        if (direction == 0) {
            if (origin < low[axis] || origin > high[axis]) return nothing;
            continue;
        }
        const double first = ((direction > 0 ? low : high)[axis] - origin) / direction;
        const double last = ((direction > 0 ? high : low)[axis] - origin) / direction;
        glm::dvec3 outward(0);
        outward[axis] = direction > 0 ? 1 : -1;
        if (first > result.range.near) {
            result.range.near = first;
            result.nearNormal = -outward;
        }
        if (last < result.range.far) {
            result.range.far = last;
            result.farNormal = outward;
        }
    }
    if (!std::isfinite(result.range.near) || !std::isfinite(result.range.far)) return nothing;
    return result;
}

void appendEnds(const Ray& ray, const LineInterval& body, RayInterval interval, HitList& hits) {
    if (body.empty()) return;
    const auto inside = [&](double t) { return interval.near <= t && t <= interval.far; };
    if (inside(body.range.near)) hits.push_back({body.range.near, ray.at(body.range.near), body.nearNormal});
    if (inside(body.range.far)) hits.push_back({body.range.far, ray.at(body.range.far), body.farNormal});
}

}  // namespace isoscope
