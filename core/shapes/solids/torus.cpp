// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/solids/torus.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/shapes/combined/turned_place.h"
#include "core/shapes/rays/centered_ray.h"
#include "core/shapes/rays/hit_list.h"

namespace isoscope {

Torus::Torus(double major, double minor, RootChoice choice)
    : major_(std::abs(major)), minor_(std::abs(minor)), choice_(choice) {}

void Torus::intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const {
    ++context.rays;
    const CenteredRay line(ray, glm::dvec3(0));
    const double outer = major_ + minor_, squaredMiss = glm::dot(line.origin, line.origin);
    if (!line.usable || !(squaredMiss < outer * outer)) return;
    // Only the part between the planes y = -minor and y = minor, with a little room for rounding.
    double reach = std::sqrt(outer * outer - squaredMiss) + 1e-6 * outer;
    double low = -reach, high = reach;
    const double room = minor_ * (1 + 1e-6), dy = line.direction.y, y = line.origin.y;
    if (dy == 0 && std::abs(y) > room) return;
    if (dy != 0) {
        const double one = (-room - y) / dy, other = (room - y) / dy;
        low = std::max(low, std::min(one, other));
        high = std::min(high, std::max(one, other));
    }
    if (!(low < high)) return;
    // (|p + s d|^2 + R^2 - r^2)^2 = 4 R^2 (x^2 + z^2)
    const double b = 2 * glm::dot(line.origin, line.direction);
    const double c = squaredMiss + (major_ - minor_) * (major_ + minor_);
    const double four = 4 * major_ * major_;
    const glm::dvec3& p = line.origin;
    const glm::dvec3& d = line.direction;
    const std::array<double, 5> quartic{1, 2 * b, b * b + 2 * c - four * (d.x * d.x + d.z * d.z),
                                        2 * b * c - 2 * four * (p.x * d.x + p.z * d.z),
                                        c * c - four * (p.x * p.x + p.z * p.z)};
    RootSequence roots;
    chosenRoots(choice_, quartic, low, high, roots);
    for (const double s : roots) {
        const double t = line.toRay(s);
        if (interval.near <= t && t <= interval.far) hits.push_back({t, ray.at(t), normalAt(line.at(s))});
    }
}

glm::dvec3 Torus::normalAt(const glm::dvec3& point) const {
    const double distance = std::hypot(point.x, point.z);
    if (distance == 0) return unitNormal(point);
    const double inward = 1 - major_ / distance;
    return unitNormal({point.x * inward, point.y, point.z * inward});
}

bool Torus::contains(const glm::dvec3& point, TraceContext&) const {
    const double off = std::hypot(point.x, point.z) - major_;
    return off * off + point.y * point.y <= minor_ * minor_;
}

Bounds Torus::bounds() const {
    const double outer = major_ + minor_;
    return {{-outer, -minor_, -outer}, {outer, minor_, outer}};
}

/// Around the tube from its inside, upwards.
std::optional<glm::dvec2> Torus::surfacePlace(const glm::dvec3& p) const {
    const double around = std::hypot(p.x, p.z) - major_;
    return glm::dvec2(turnedPlace(-p.x, p.z), 0.5 + std::atan2(p.y, around) / (2 * std::numbers::pi));
}

}  // namespace isoscope
