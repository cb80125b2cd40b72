// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/solids/disc.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "core/shapes/solids/plane.h"

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
    constexpr double halfThickness = 1e-3;
    const glm::dvec3& n = normal_;
    // 1 / (1 + n.z), which would lose its digits close to the negative z axis. On it there is no shortest
    // turn; the square is the same.
    const double across = n.x * n.x + n.y * n.y;
    const double part = across > 0 ? (1 - n.z) / across : 0;
    const glm::dvec3 right(1 - n.x * n.x * part, -n.x * n.y * part, -n.x);
    const glm::dvec3 up(-n.x * n.y * part, 1 - n.y * n.y * part, -n.y);
    const glm::dvec3 reach = radius_ * (glm::abs(right) + glm::abs(up)) + halfThickness * glm::abs(n);
    return {center_ - reach, center_ + reach};
}

Bounds Disc::boundsWithin(const Bounds& room) const {
    if (normal_ == glm::dvec3(0)) return isoscope::intersect(bounds(), room);
    return isoscope::intersect(Plane(normal_, glm::dot(normal_, center_)).bounds(), room);
}

}  // namespace isoscope
