// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/solids/plane.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "core/shapes/rays/hit_list.h"
#include "core/shapes/rays/solid_lanes.h"

namespace isoscope {

namespace {

/// Rays that are parallel but for rounding meet the plane nowhere sensible. Measured on POV-Ray: 1e7 is met,
/// more is not.
constexpr double horizon = 1e7;
/// Points this near count as inside: a ray through the very edge of two half-spaces must not slip between
/// them.
constexpr double skin = 1e-10;

}  // namespace

Plane::Plane(const glm::dvec3& normal, double distance) : normal_(0), distance_(distance) {
    const double length = glm::length(normal);
    if (length > 0 && std::isfinite(length)) normal_ = normal / length;
}

bool Plane::meet(const Ray& ray, RayInterval interval, double& t) const {
    const double approach = glm::dot(normal_, ray.direction);
    if (approach == 0) return false;
    t = (distance_ - glm::dot(normal_, ray.origin)) / approach;
    return interval.near <= t && t <= interval.far && t * glm::length(ray.direction) <= horizon;
}

void Plane::intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const {
    ++context.rays;
    double t = 0;
    if (meet(ray, interval, t)) hits.push_back({t, ray.at(t), normal_});
}

void Plane::nearest(std::span<const Ray> rays, TraceContext& context, std::span<NearestHit> nearest) const {
    context.rays += rays.size();
    for (std::size_t i = 0; i < rays.size(); ++i) {
        RayInterval interval;
        interval.near = context.nearLimit;
        if (nearest[i].found) interval.far = nearest[i].hit.t;
        double t = 0;
        if (meet(rays[i], interval, t)) offer({t, rays[i].at(t), normal_}, nearest[i]);
    }
}

void Plane::nearestInBatch(const RayBatch& rays, TraceContext& context, HitBatch& hits) const {
    context.rays += rays.size();
    meetPlane(normal_, distance_, horizon, {rays, context.nearLimit, !context.shadowRay, hits});
}

void Plane::spans(const RayBatch& rays, SpanBatch& spans) const {
    findPlaneSpans(normal_, distance_, horizon, rays, spans);
}

bool Plane::contains(const glm::dvec3& point, TraceContext&) const {
    return normal_ != glm::dvec3(0) && glm::dot(normal_, point) < distance_ + skin;
}

Bounds Plane::bounds() const {
    Bounds result;
    for (int axis = 0; axis < 3; ++axis) {
        if (normal_[axis] == 1) result.high[axis] = distance_;
        if (normal_[axis] == -1) result.low[axis] = -distance_;
    }
    return result;
}

Bounds Plane::complementWithin(const Bounds& room) const {
    return isoscope::intersect(room, Plane(-normal_, -distance_).bounds());
}

}  // namespace isoscope
