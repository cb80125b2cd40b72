// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/solids/cone.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>

#include "core/roots/polynomial/real_roots.h"
#include "core/shapes/rays/hit_list.h"
#include "core/shapes/rays/solid_lanes.h"

namespace isoscope {

namespace {

/// How much smaller the solid is than its surface, as measured on POV-Ray, which brings cylinders and cones
/// to length 1 and radius 1 (cones with their tips, but not when the radii differ by 1e-6 of themselves):
/// where surfaces coincide in CSG it decides what shows.
constexpr double skin = 1e-10;

}  // namespace

Cone::Cone(const glm::dvec3& base, double baseRadius, const glm::dvec3& cap, double capRadius, bool open)
    : center_((base + cap) * 0.5),
      baseRadius_(std::abs(baseRadius)),
      capRadius_(std::abs(capRadius)),
      open_(open) {
    const double length = glm::distance(base, cap);
    if (!(length > 0) || !std::isfinite(length)) return;
    axis_ = (cap - base) / length;
    half_ = length / 2;
    middleRadius_ = (baseRadius_ + capRadius_) / 2;
    slope_ = (capRadius_ - baseRadius_) / length;
}

void Cone::intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const {
    ++context.rays;
    const CenteredRay line(ray, center_);
    if (!line.usable || half_ == 0) return;
    const std::size_t first = hits.size();
    addSide(ray, line, interval, hits);
    if (!open_) {
        addCap(ray, line, -half_, interval, hits);
        addCap(ray, line, half_, interval, hits);
    }
    sortHits(hits, first);
}

void Cone::nearestInBatch(const RayBatch& rays, TraceContext& context, HitBatch& hits) const {
    context.rays += rays.size();
    if (half_ == 0) return;
    std::vector<std::uint32_t> doubtful;
    meetCone(form(), {rays, context.nearLimit, !context.shadowRay, hits}, doubtful);
    context.rays -= doubtful.size();
    HitList own;
    for (const std::uint32_t i : doubtful) {
        own.clear();
        intersect(rays.ray(i), {context.nearLimit, hits[HitBatch::t][i]}, context, own);
        hits.offer(i, own);
    }
}

void Cone::spans(const RayBatch& rays, SpanBatch& spans) const { findConeSpans(form(), rays, spans); }

ConeForm Cone::form() const {
    return {center_, axis_, half_, middleRadius_, slope_, baseRadius_, capRadius_, open_};
}

void Cone::addSide(const Ray& ray, const CenteredRay& line, RayInterval interval, HitList& hits) const {
    const double height = glm::dot(line.origin, axis_), climb = glm::dot(line.direction, axis_);
    const glm::dvec3 across = line.origin - height * axis_, sideways = line.direction - climb * axis_;
    const double radius = radiusAt(height), growth = slope_ * climb;
    const std::array<double, 3> quadratic{glm::dot(sideways, sideways) - growth * growth,
                                          2 * (glm::dot(across, sideways) - growth * radius),
                                          glm::dot(across, across) - radius * radius};
    RootSequence roots;
    realRoots(quadratic, -2 * farthestDistance, 2 * farthestDistance, roots);
    for (const double s : roots) {
        const double at = height + s * climb, t = line.toRay(s);
        if (!(std::abs(at) <= half_) || !(interval.near <= t && t <= interval.far)) continue;
        hits.push_back({t, ray.at(t), unitNormal(across + s * sideways - slope_ * radiusAt(at) * axis_)});
    }
}

void Cone::addCap(const Ray& ray, const CenteredRay& line, double end, RayInterval interval,
                  HitList& hits) const {
    const double climb = glm::dot(line.direction, axis_);
    if (climb == 0) return;
    const double s = (end - glm::dot(line.origin, axis_)) / climb, t = line.toRay(s);
    const double radius = end < 0 ? baseRadius_ : capRadius_;
    const glm::dvec3 arm = line.at(s) - end * axis_;
    if (!(glm::dot(arm, arm) <= radius * radius) || !(interval.near <= t && t <= interval.far)) return;
    if (radius > 0) hits.push_back({t, ray.at(t), end < 0 ? -axis_ : axis_});
}

bool Cone::contains(const glm::dvec3& point, TraceContext&) const {
    const glm::dvec3 arm = point - center_;
    const double height = glm::dot(arm, axis_);
    const glm::dvec3 across = arm - height * axis_;
    const double narrowing = std::abs(baseRadius_ - capRadius_), wide = std::max(baseRadius_, capRadius_);
    const double whole = narrowing > 1e-5 * wide ? 2 * half_ * wide / narrowing : 2 * half_;
    const double radius = radiusAt(height);
    return half_ > 0 && std::abs(height) < half_ - skin * whole &&
           glm::dot(across, across) < radius * radius - skin * wide * wide;
}

Bounds Cone::bounds() const {
    // POV-Ray's: a box of the larger radius around the z axis, turned to the axis on the shortest way.
    if (half_ == 0) return {center_, center_};
    const double radius = std::max(baseRadius_, capRadius_);
    glm::dvec3 across(1, 0, 0), beside(0, 1, 0);
    const double level = axis_.x * axis_.x + axis_.y * axis_.y;
    if (level > 0) {
        const double k = (1 - axis_.z) / level;
        across = {1 - k * axis_.x * axis_.x, -k * axis_.x * axis_.y, -axis_.x};
        beside = {-k * axis_.x * axis_.y, 1 - k * axis_.y * axis_.y, -axis_.y};
    }
    const glm::dvec3 reach = radius * (glm::abs(across) + glm::abs(beside)) + half_ * glm::abs(axis_);
    return {center_ - reach, center_ + reach};
}

}  // namespace isoscope
