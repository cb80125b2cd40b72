// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/solids/sphere.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/shapes/combined/turned_place.h"
#include "core/shapes/rays/hit_list.h"
#include "core/shapes/rays/line_interval.h"
#include "core/shapes/rays/solid_lanes.h"

namespace isoscope {

Sphere::Sphere(const glm::dvec3& center, double radius) : center_(center), radius_(std::abs(radius)) {}

void Sphere::intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const {
    ++context.rays;
    appendSphereEnds(ray, center_, radius_, interval, hits);
}

void Sphere::nearest(std::span<const Ray> rays, TraceContext& context, std::span<NearestHit> nearest) const {
    context.rays += rays.size();
    for (std::size_t i = 0; i < rays.size(); ++i)
        offerSphereEnd(rays[i], center_, radius_, context.nearLimit, nearest[i]);
}

void Sphere::nearestInBatch(const RayBatch& rays, TraceContext& context, HitBatch& hits) const {
    context.rays += rays.size();
    meetSphere(center_, radius_, {rays, context.nearLimit, !context.shadowRay, hits});
}

void Sphere::spans(const RayBatch& rays, SpanBatch& spans) const {
    findSphereSpans(center_, radius_, rays, spans);
}

bool Sphere::contains(const glm::dvec3& point, TraceContext&) const {
    const glm::dvec3 arm = point - center_;
    return glm::dot(arm, arm) < radius_ * radius_;
}

Bounds Sphere::bounds() const { return {center_ - radius_, center_ + radius_}; }

std::optional<glm::dvec2> Sphere::surfacePlace(const glm::dvec3& point) const {
    const glm::dvec3 arm = point - center_;
    const double height = radius_ > 0 ? std::clamp(arm.y / radius_, -1.0, 1.0) : 0;
    return glm::dvec2(turnedPlace(arm.x, arm.z), 0.5 + std::asin(height) / std::numbers::pi);
}

}  // namespace isoscope
