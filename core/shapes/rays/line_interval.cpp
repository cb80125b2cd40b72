// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/rays/line_interval.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/shapes/rays/hit_list.h"

namespace isoscope {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The part of a line in a sphere, seen from the point of closest approach.
struct Chord {
    double middle = 0;
    double half = 0;       ///< 0 for a miss
    glm::dvec3 across{0};  ///< from the centre to the middle

    RayInterval range() const { return half > 0 ? RayInterval{middle - half, middle + half} : nothing(); }
    static RayInterval nothing() { return LineInterval().range; }
};

Chord chord(const Ray& ray, const glm::dvec3& center, double radius) {
    const double squaredSpeed = glm::dot(ray.direction, ray.direction);
    if (!(squaredSpeed > 0)) return {};
    // No cancellation for far origins.
    const glm::dvec3 arm = ray.origin - center;
    const double middle = -glm::dot(arm, ray.direction) / squaredSpeed;
    const glm::dvec3 across = arm + middle * ray.direction;
    const double squaredChord = (radius * radius - glm::dot(across, across)) / squaredSpeed;
    if (!(squaredChord > 0)) return {};
    const double half = std::sqrt(squaredChord);
    if (!std::isfinite(middle) || !std::isfinite(half)) return {};
    return {middle, half, across};
}

/// The part of a line in a box and the axes across whose faces it enters and leaves.
struct BoxPassage {
    RayInterval range = LineInterval().range;
    int nearAxis = 0;
    int farAxis = 0;
};

BoxPassage passage(const Ray& ray, const glm::dvec3& low, const glm::dvec3& high) {
    BoxPassage result;
    result.range = {-infinity, infinity};
    for (int axis = 0; axis < 3; ++axis) {
        const double origin = ray.origin[axis];
        const double direction = ray.direction[axis];
        if (!std::isfinite(origin) || !std::isfinite(direction) || !(low[axis] <= high[axis])) return {};
        if (direction == 0) {
            if (origin < low[axis] || origin > high[axis]) return {};
            continue;
        }
        const double first = ((direction > 0 ? low : high)[axis] - origin) / direction;
        const double last = ((direction > 0 ? high : low)[axis] - origin) / direction;
        if (first > result.range.near) {
            result.range.near = first;
            result.nearAxis = axis;
        }
        if (last < result.range.far) {
            result.range.far = last;
            result.farAxis = axis;
        }
    }
    if (!std::isfinite(result.range.near) || !std::isfinite(result.range.far)) return {};
    return result;
}

/// The outward normal of the face of `axis` that lies forwards or backwards of the ray.
glm::dvec3 faceNormal(const Ray& ray, int axis, bool forwards) {
    glm::dvec3 normal(0);
    normal[axis] = (ray.direction[axis] > 0) == forwards ? 1 : -1;
    return normal;
}

}  // namespace

RayInterval sphereRange(const Ray& ray, const glm::dvec3& center, double radius) {
    return chord(ray, center, radius).range();
}

RayInterval boxRange(const Ray& ray, const glm::dvec3& low, const glm::dvec3& high) {
    return passage(ray, low, high).range;
}

glm::dvec3 sphereNormal(const Ray& ray, const glm::dvec3& center, double radius, bool entering) {
    const Chord inside = chord(ray, center, radius);
    if (!(inside.half > 0)) return {1, 0, 0};
    const glm::dvec3 along = inside.half * ray.direction;
    return unitNormal(entering ? inside.across - along : inside.across + along);
}

LineInterval sphereInterval(const Ray& ray, const glm::dvec3& center, double radius) {
    const Chord inside = chord(ray, center, radius);
    LineInterval result;
    if (!(inside.half > 0)) return result;
    result.range = inside.range();
    result.nearNormal = unitNormal(inside.across - inside.half * ray.direction);
    result.farNormal = unitNormal(inside.across + inside.half * ray.direction);
    return result;
}

LineInterval boxInterval(const Ray& ray, const glm::dvec3& low, const glm::dvec3& high) {
    const BoxPassage inside = passage(ray, low, high);
    LineInterval result;
    result.range = inside.range;
    if (result.empty()) return result;
    result.nearNormal = faceNormal(ray, inside.nearAxis, false);
    result.farNormal = faceNormal(ray, inside.farAxis, true);
    return result;
}

void appendSphereEnds(const Ray& ray, const glm::dvec3& center, double radius, RayInterval interval,
                      HitList& hits) {
    const Chord inside = chord(ray, center, radius);
    if (!(inside.half > 0)) return;
    const RayInterval range = inside.range();
    const glm::dvec3 along = inside.half * ray.direction;
    const auto contains = [&](double t) { return interval.near <= t && t <= interval.far; };
    if (contains(range.near))
        hits.push_back({range.near, ray.at(range.near), unitNormal(inside.across - along)});
    if (contains(range.far))
        hits.push_back({range.far, ray.at(range.far), unitNormal(inside.across + along)});
}

void offerSphereEnd(const Ray& ray, const glm::dvec3& center, double radius, double nearLimit,
                    NearestHit& nearest) {
    const Chord inside = chord(ray, center, radius);
    if (!(inside.half > 0)) return;
    const RayInterval range = inside.range();
    const bool entering = range.near >= nearLimit;
    const double t = entering ? range.near : range.far;
    if (!(t >= nearLimit && (!nearest.found || t < nearest.hit.t))) return;
    const glm::dvec3 along = inside.half * ray.direction;
    nearest = {true, {t, ray.at(t), unitNormal(entering ? inside.across - along : inside.across + along)}};
}

void appendEnds(const Ray& ray, const LineInterval& body, RayInterval interval, HitList& hits) {
    if (body.empty()) return;
    const auto inside = [&](double t) { return interval.near <= t && t <= interval.far; };
    if (inside(body.range.near)) hits.push_back({body.range.near, ray.at(body.range.near), body.nearNormal});
    if (inside(body.range.far)) hits.push_back({body.range.far, ray.at(body.range.far), body.farNormal});
}

}  // namespace isoscope
