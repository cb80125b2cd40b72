// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/cone.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/roots/real_roots.h"
#include "core/shapes/hit_list.h"

namespace isoscope {

namespace {

/// Points this share of the size outside count as inside, as in POV-Ray: coinciding surfaces in CSG then agree.
constexpr double skin = 1e-9;

}  // namespace

Cone::Cone(const glm::dvec3& base, double baseRadius, const glm::dvec3& cap, double capRadius, bool open)
    : center_((base + cap) * 0.5), baseRadius_(std::abs(baseRadius)), capRadius_(std::abs(capRadius)), open_(open) {
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

void Cone::addCap(const Ray& ray, const CenteredRay& line, double end, RayInterval interval, HitList& hits) const {
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
    const double room = skin * std::max({half_, baseRadius_, capRadius_});
    const double radius = std::max(radiusAt(height), 0.0) + room;
    return half_ > 0 && std::abs(height) < half_ + room && glm::dot(across, across) < radius * radius;
}

Bounds Cone::bounds() const {
    // How far a disc at right angles to the axis reaches along each coordinate.
    const glm::dvec3 reach = glm::sqrt(glm::max(glm::dvec3(1) - axis_ * axis_, glm::dvec3(0)));
    const auto disc = [&](double end, double radius) {
        const glm::dvec3 at = center_ + end * axis_;
        return Bounds{at - radius * reach, at + radius * reach};
    };
    return unite(disc(-half_, baseRadius_), disc(half_, capRadius_));
}

}  // namespace isoscope
