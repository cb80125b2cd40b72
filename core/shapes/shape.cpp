// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/shape.h"

#include "core/shapes/hit_list.h"

namespace isoscope {

void Shape::nearest(std::span<const Ray> rays, TraceContext& context, std::span<NearestHit> nearest) const {
    HitList hits;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        hits.clear();
        RayInterval interval;
        interval.near = context.nearLimit;
        if (nearest[i].found) interval.far = nearest[i].hit.t;
        intersect(rays[i], interval, context, hits);
        if (!hits.empty()) offer(hits.front(), nearest[i]);
    }
}

void Shape::allHits(std::span<const Ray> rays, TraceContext& context, std::span<HitList> hits) const {
    for (std::size_t i = 0; i < rays.size(); ++i) {
        hits[i].clear();
        intersect(rays[i], {}, context, hits[i]);
    }
}

}  // namespace isoscope
