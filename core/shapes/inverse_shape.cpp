// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/inverse_shape.h"

namespace isoscope {

void InverseShape::intersect(const Ray& ray, RayInterval interval, TraceContext& context,
                             HitList& hits) const {
    const std::size_t first = hits.size();
    shape_->intersect(ray, interval, context, hits);
    for (std::size_t i = first; i < hits.size(); ++i) hits[i].normal = -hits[i].normal;
}

void InverseShape::nearest(std::span<const Ray> rays, TraceContext& context,
                           std::span<NearestHit> nearest) const {
    std::vector<NearestHit> own(nearest.begin(), nearest.end());
    shape_->nearest(rays, context, own);
    for (std::size_t i = 0; i < own.size(); ++i) {
        if (!own[i].found || (nearest[i].found && !(own[i].hit.t < nearest[i].hit.t))) continue;
        nearest[i] = own[i];
        nearest[i].hit.normal = -nearest[i].hit.normal;
    }
}

void InverseShape::allHits(std::span<const Ray> rays, TraceContext& context, std::span<HitList> hits) const {
    shape_->allHits(rays, context, hits);
    for (HitList& list : hits)
        for (Hit& hit : list) hit.normal = -hit.normal;
}

bool InverseShape::contains(const glm::dvec3& point, TraceContext& context) const {
    return !shape_->contains(point, context);
}

}  // namespace isoscope
