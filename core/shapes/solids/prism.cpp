// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/solids/prism.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/shapes/rays/hit_list.h"

namespace isoscope {

Prism::Prism(std::vector<CurvePiece> outline, double height1, double height2, const PrismStyle& style)
    : outline_(std::move(outline)),
      low_(std::min(height1, height2)),
      high_(std::max(height1, height2)),
      style_(style),
      bounds_(findBounds()) {}

void Prism::intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const {
    ++context.rays;
    const RayInterval inside = bounds_.clip(ray);
    if (!(inside.near <= inside.far * (1 + 1e-9) + 1e-300)) return;
    const std::size_t first = hits.size();
    for (std::size_t i = 0; i < outline_.pieces().size(); ++i) {
        if (style_.conic)
            addConicSide(i, ray, interval, hits);
        else
            addStraightSide(i, ray, interval, hits);
    }
    if (!style_.open) {
        addCap(low_, ray, interval, hits);
        addCap(high_, ray, interval, hits);
    }
    sortHits(hits, first);
}

void Prism::addStraightSide(std::size_t piece, const Ray& ray, RayInterval interval, HitList& hits) const {
    const glm::dvec2 d(ray.direction.x, ray.direction.z), o(ray.origin.x, ray.origin.z);
    const double square = glm::dot(d, d);
    if (!(square > 0)) return;
    const glm::dvec2 across(d.y, -d.x);
    const double value = glm::dot(across, o);
    if (!outline_.mayMeet(piece, across, value)) return;
    RootSequence roots;
    outline_.pieces()[piece].meet(across, value, roots);
    for (const double u : roots)
        addSide(piece, u, glm::dot(outline_.pieces()[piece].at(u) - o, d) / square, ray, interval, hits);
}

void Prism::addConicSide(std::size_t piece, const Ray& ray, RayInterval interval, HitList& hits) const {
    // The plane through the ray and the tip meets the outline at height 1.
    const glm::dvec3 normal = glm::cross(ray.origin, ray.direction);
    if (!outline_.mayMeet(piece, {normal.x, normal.z}, -normal.y)) return;
    RootSequence roots;
    outline_.pieces()[piece].meet({normal.x, normal.z}, -normal.y, roots);
    for (const double u : roots) {
        const glm::dvec2 at = outline_.pieces()[piece].at(u);
        const glm::dvec3 spoke(at.x, 1, at.y);
        const glm::dvec3 arm = glm::cross(ray.origin, spoke), speed = glm::cross(ray.direction, spoke);
        const double square = glm::dot(speed, speed);
        if (square > 0) addSide(piece, u, -glm::dot(arm, speed) / square, ray, interval, hits);
    }
}

void Prism::addSide(std::size_t piece, double u, double t, const Ray& ray, RayInterval interval,
                    HitList& hits) const {
    if (!(interval.near <= t && t <= interval.far)) return;
    const glm::dvec3 at = ray.at(t);
    if (!(at.y >= low_ && at.y <= high_)) return;
    const glm::dvec2 slope = outline_.pieces()[piece].slope(u);
    glm::dvec3 normal(slope.y, 0, -slope.x);
    if (style_.conic) {
        // Across the tangent of the outline and the line to the tip.
        const glm::dvec2 place = outline_.pieces()[piece].at(u);
        normal = glm::dvec3(slope.y, slope.x * place.y - slope.y * place.x, -slope.x);
    }
    hits.push_back({t, at, unitNormal(normal)});
}

void Prism::addCap(double height, const Ray& ray, RayInterval interval, HitList& hits) const {
    if (ray.direction.y == 0 || (style_.conic && height == 0)) return;
    const double t = (height - ray.origin.y) / ray.direction.y;
    if (!(interval.near <= t && t <= interval.far) || !std::isfinite(t)) return;
    glm::dvec3 at = ray.at(t);
    at.y = height;
    if (outline_.covers(unswept(at)))
        hits.push_back({t, at, {0, style_.outwardCaps && height == low_ ? -1 : 1, 0}});
}

glm::dvec2 Prism::unswept(const glm::dvec3& point) const {
    const double scale = style_.conic ? point.y : 1;
    return glm::dvec2(point.x, point.z) / scale;
}

bool Prism::contains(const glm::dvec3& point, TraceContext&) const {
    if (!(point.y >= low_ && point.y <= high_) || (style_.conic && point.y == 0)) return false;
    return outline_.covers(unswept(point));
}

Bounds Prism::findBounds() const {
    const glm::dvec2 a = glm::min(outline_.low(), style_.statedLow),
                     b = glm::max(outline_.high(), style_.statedHigh);
    if (!style_.conic) return {{a.x, low_, a.y}, {b.x, high_, b.y}};
    glm::dvec2 low = glm::min(a * low_, a * high_), high = glm::max(b * low_, b * high_);
    low = glm::min(low, glm::min(b * low_, b * high_));
    high = glm::max(high, glm::max(a * low_, a * high_));
    return {{low.x, low_, low.y}, {high.x, high_, high.y}};
}

}  // namespace isoscope
