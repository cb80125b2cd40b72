// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/quadric.h"

#include <array>

#include "core/roots/real_roots.h"
#include "core/shapes/centered_ray.h"
#include "core/shapes/hit_list.h"

namespace isoscope {

Quadric::Quadric(const glm::dvec3& squares, const glm::dvec3& products, const glm::dvec3& linear,
                 double constant)
    : squares_(squares), products_(products), linear_(linear), constant_(constant) {}

void Quadric::intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const {
    ++context.rays;
    const CenteredRay line(ray, glm::dvec3(0));
    if (!line.usable) return;
    const glm::dvec3& d = line.direction;
    const glm::dvec3 crossed(d.x * d.y, d.x * d.z, d.y * d.z);
    const std::array<double, 3> quadratic{glm::dot(squares_, d * d) + glm::dot(products_, crossed),
                                          glm::dot(gradientAt(line.origin), d), valueAt(line.origin)};
    const double start = line.fromRay(0);
    RootSequence roots;
    realRoots(quadratic, start - farthestDistance, start + farthestDistance, roots);
    // A double root: the surface is touched, not crossed, as at the tip of a cone.
    if (quadratic[0] != 0 && roots.size() == 1) roots.clear();
    for (const double s : roots) {
        const double t = line.toRay(s);
        if (interval.near <= t && t <= interval.far)
            hits.push_back({t, ray.at(t), unitNormal(gradientAt(line.at(s)))});
    }
}

bool Quadric::contains(const glm::dvec3& point, TraceContext&) const { return valueAt(point) <= 0; }

double Quadric::valueAt(const glm::dvec3& p) const {
    return glm::dot(squares_, p * p) + glm::dot(products_, glm::dvec3(p.x * p.y, p.x * p.z, p.y * p.z)) +
           glm::dot(linear_, p) + constant_;
}

glm::dvec3 Quadric::gradientAt(const glm::dvec3& p) const {
    return 2.0 * squares_ * p + linear_ +
           glm::dvec3(products_.x * p.y + products_.y * p.z, products_.x * p.x + products_.z * p.z,
                      products_.y * p.x + products_.z * p.y);
}

}  // namespace isoscope
