// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/shape.h"

#include "core/shapes/composition.h"
#include "core/shapes/rays/hit_batch.h"
#include "core/shapes/rays/hit_list.h"
#include "core/shapes/rays/ray_batch.h"

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

void Shape::nearestInBatch(const RayBatch& batch, TraceContext& context, HitBatch& hits) const {
    std::vector<Ray> rays(batch.size());
    std::vector<NearestHit> found(batch.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        rays[i] = batch.ray(i);
        found[i].found = hits.found(i);
        found[i].hit.t = hits[HitBatch::t][i];
    }
    nearest(rays, context, found);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Hit& hit = found[i].hit;
        if (found[i].found && hit.t < hits[HitBatch::t][i])
            hits.set(i, hit.t, hit.normal, hit.kind, hit.material);
    }
}

void Shape::allHits(std::span<const Ray> rays, TraceContext& context, std::span<HitList> hits) const {
    for (std::size_t i = 0; i < rays.size(); ++i) {
        hits[i].clear();
        intersect(rays[i], {}, context, hits[i]);
    }
}

Composition Shape::composition() const { return {}; }

ShapePointer Shape::withParts(std::vector<ShapePointer>, std::vector<ShapePointer>) const { return nullptr; }

}  // namespace isoscope
