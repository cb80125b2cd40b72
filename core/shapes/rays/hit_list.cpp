// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/rays/hit_list.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace isoscope {

void sortHits(HitList& hits, std::size_t first) {
    // Most lists are short, and in order.
    constexpr std::size_t fewHits = 12;
    if (hits.size() - first <= fewHits) {
        for (std::size_t i = first + 1; i < hits.size(); ++i)
            for (std::size_t k = i; k > first && hits[k].t < hits[k - 1].t; --k)
                std::swap(hits[k], hits[k - 1]);
        return;
    }
    std::stable_sort(hits.begin() + static_cast<std::ptrdiff_t>(first), hits.end(),
                     [](const Hit& a, const Hit& b) { return a.t < b.t; });
}

void nearestOfAll(const Shape& shape, std::span<const Ray> rays, TraceContext& context,
                  std::span<NearestHit> nearest) {
    if (!shape.searchesBundles()) return shape.Shape::nearest(rays, context, nearest);
    std::vector<HitList> hits(rays.size());
    shape.allHits(rays, context, hits);
    for (std::size_t i = 0; i < rays.size(); ++i)
        for (const Hit& hit : hits[i]) {
            if (!(hit.t >= context.nearLimit)) continue;
            offer(hit, nearest[i]);
            break;
        }
}

glm::dvec3 scaledUnitNormal(const glm::dvec3& normal) {
    const double largest = std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
    if (!(largest > 0) || !std::isfinite(largest)) return {1, 0, 0};
    const glm::dvec3 scaled = normal / largest;
    const double length = glm::length(scaled);
    return std::isfinite(length) ? scaled / length : glm::dvec3(1, 0, 0);
}

}  // namespace isoscope
