// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/patches/polygon.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace isoscope {

Polygon::Polygon(const std::vector<glm::dvec3>& points) {
    std::size_t start = 0;
    glm::dvec3 area(0), low(points.empty() ? glm::dvec3(0) : points.front()), high(low);
    for (std::size_t i = 0; i < points.size(); ++i) {
        low = glm::min(low, points[i]);
        high = glm::max(high, points[i]);
        const bool last = i + 1 == points.size();
        if (i == start && !last) continue;
        if (i > start) edges_.push_back({points[i - 1], points[i]});
        const bool closed = i > start && points[i] == points[start];
        if (!closed && last && i > start) edges_.push_back({points[i], points[start]});
        if (closed) start = i + 1;
    }
    for (const Edge& edge : edges_) area += glm::cross(edge.from - low, edge.to - low);
    const double size = glm::length(area);
    if (!(size > 0) || !std::isfinite(size)) {
        edges_.clear();
        return;
    }
    normal_ = area / size;
    center_ = edges_.front().from;
    bounds_ = {low, high};
    const glm::dvec3 steep = glm::abs(normal_);
    const int dropped = steep.x > steep.y ? (steep.x > steep.z ? 0 : 2) : (steep.y > steep.z ? 1 : 2);
    across_ = (dropped + 1) % 3;
    along_ = (dropped + 2) % 3;
}

void Polygon::intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const {
    ++context.rays;
    const double approach = glm::dot(normal_, ray.direction);
    if (approach == 0) return;
    const double t = glm::dot(normal_, center_ - ray.origin) / approach;
    if (!(interval.near <= t && t <= interval.far) || !std::isfinite(t) || !covers(ray.at(t))) return;
    hits.push_back({t, ray.at(t), normal_});
}

bool Polygon::covers(const glm::dvec3& point) const {
    bool inside = false;
    for (const Edge& edge : edges_) {
        const double y0 = edge.from[along_] - point[along_], y1 = edge.to[along_] - point[along_];
        if ((y0 > 0) == (y1 > 0)) continue;
        const double x0 = edge.from[across_] - point[across_], x1 = edge.to[across_] - point[across_];
        if ((x0 * y1 - x1 * y0 > 0) == (y1 > y0)) inside = !inside;
    }
    return inside;
}

}  // namespace isoscope
