// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/shadowless_shape.h"

namespace isoscope {

void ShadowlessShape::intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const {
    if (!context.shadowRay) shape_->intersect(ray, interval, context, hits);
}

void ShadowlessShape::nearest(std::span<const Ray> rays, TraceContext& context, std::span<NearestHit> nearest) const {
    if (!context.shadowRay) shape_->nearest(rays, context, nearest);
}

void ShadowlessShape::allHits(std::span<const Ray> rays, TraceContext& context, std::span<HitList> hits) const {
    if (!context.shadowRay) return shape_->allHits(rays, context, hits);
    for (HitList& list : hits) list.clear();
}

bool ShadowlessShape::contains(const glm::dvec3& point, TraceContext& context) const {
    return shape_->contains(point, context);
}

}  // namespace isoscope
