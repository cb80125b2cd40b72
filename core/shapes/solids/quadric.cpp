// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/solids/quadric.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vector_relational.hpp>
#include <limits>

#include "core/roots/polynomial/real_roots.h"
#include "core/shapes/rays/centered_ray.h"
#include "core/shapes/rays/hit_list.h"

namespace isoscope {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A lower bound of a x^2 + b x over [low, high], whose ends may be infinite.
double leastOf(double a, double b, double low, double high) {
    const auto at = [a, b](double x) { return std::isfinite(x) ? (a * x + b) * x : -infinity; };
    if (a > 0) {
        const double x = std::clamp(-b / (2 * a), low, high);
        return (a * x + b) * x;
    }
    if (a == 0 && b == 0) return 0;
    if (a == 0) return b * (b > 0 ? low : high);
    return std::min(at(low), at(high));
}

/// Cuts [low, high] to where a x^2 + b x + c may be 0 or less; only parabolas that open upwards and straight
/// lines cut.
void cut(double a, double b, double c, double& low, double& high) {
    if (!std::isfinite(c)) return;
    if (a > 0) {
        const double square = b * b - 4 * a * c;
        const double reach = square > 0 ? std::sqrt(square) / (2 * a) : square == 0 ? 0 : -infinity;
        low = std::max(low, -b / (2 * a) - reach);
        high = std::min(high, -b / (2 * a) + reach);
    } else if (a == 0 && b > 0) {
        high = std::min(high, -c / b);
    } else if (a == 0 && b < 0) {
        low = std::max(low, -c / b);
    }
}

}  // namespace

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

Bounds Quadric::boundsWithin(const Bounds& room) const {
    Bounds box = room;
    if (products_ != glm::dvec3(0)) return box;
    constexpr int rounds = 2;  // for an axis may be bounded only once another is
    for (int round = 0; round < rounds; ++round)
        for (int axis = 0; axis < 3; ++axis) {
            if (!glm::all(glm::lessThanEqual(box.low, box.high))) return box;
            double rest = constant_, size = std::abs(constant_);
            for (int other = 0; other < 3; ++other) {
                if (other == axis) continue;
                const double least =
                    leastOf(squares_[other], linear_[other], box.low[other], box.high[other]);
                rest += least;
                size += std::abs(least);
            }
            constexpr double rounding = 1e-12;
            Bounds smaller = box;
            cut(squares_[axis], linear_[axis], rest - rounding * size, smaller.low[axis], smaller.high[axis]);
            box = isoscope::intersect(box, grown(smaller));
        }
    return box;
}

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
