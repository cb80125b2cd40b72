// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/solids/disc.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace isoscope {

Disc::Disc(const glm::dvec3& center, const glm::dvec3& normal, double radius, double holeRadius)
    : center_(center), radius_(std::abs(radius)), holeRadius_(std::abs(holeRadius)) {
    const double length = glm::length(normal);
    if (length > 0 && std::isfinite(length)) normal_ = normal / length;
}

void Disc::intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const {
    ++context.rays;
    const double approach = glm::dot(normal_, ray.direction);
    if (approach == 0) return;
    const double t = glm::dot(normal_, center_ - ray.origin) / approach;
    if (!(interval.near <= t && t <= interval.far) || !std::isfinite(t)) return;
    const double off = glm::distance(ray.at(t), center_);
    if (off <= radius_ && off >= holeRadius_) hits.push_back({t, ray.at(t), normal_});
}

bool Disc::contains(const glm::dvec3& point, TraceContext&) const {
    return normal_ != glm::dvec3(0) && glm::dot(point - center_, normal_) < 0;
}

Bounds Disc::bounds() const {
    const glm::dvec3 reach = radius_ * glm::sqrt(glm::max(glm::dvec3(1) - normal_ * normal_, glm::dvec3(0)));
    return {center_ - reach, center_ + reach};
}

}  // namespace isoscope
