// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/object_tracer.h"

#include <cstdint>

namespace isoscope {

namespace {

bool reaches(const Bounds& bounds, const Ray& ray, const NearestHit& soFar) {
    const RayInterval inside = bounds.clip(ray);
    return !inside.empty() && !(soFar.found && inside.near > soFar.hit.t);
}

}  // namespace

void ObjectTracer::nearest(std::span<const Ray> rays, TraceContext& context, GatheredRays& asked,
                           std::span<NearestHit> nearest) const {
    const std::optional<RayBundle> bundle = bundleOf(rays);
    for (const Entry& entry : objects_) {
        if (bundle && !bundle->mayMeet(entry.bounds)) continue;
        asked.clear();
        for (std::size_t i = 0; i < rays.size(); ++i)
            if (reaches(entry.bounds, rays[i], nearest[i])) asked.add(i, rays[i], nearest[i]);
        if (asked.rays.empty()) continue;
        entry.object->shape->nearest(asked.rays, context, asked.nearest);
        for (std::size_t k = 0; k < asked.indices.size(); ++k) {
            NearestHit& best = nearest[asked.indices[k]];
            const NearestHit& met = asked.nearest[k];
            if (!met.found || (best.found && !(met.hit.t < best.hit.t))) continue;
            best = met;
            if (best.hit.material == noMaterial) best.hit.material = entry.object->material;
        }
    }
}

void ObjectTracer::blocked(std::span<const Ray> rays, std::span<const double> limits, TraceContext& context,
                           GatheredRays& asked, std::span<std::uint8_t> blocked) const {
    const std::optional<RayBundle> bundle = bundleOf(rays);
    for (const Entry& entry : objects_) {
        if (bundle && !bundle->mayMeet(entry.bounds)) continue;
        asked.clear();
        for (std::size_t i = 0; i < rays.size(); ++i) {
            if (blocked[i]) continue;
            // A hit at the light is given beforehand: only nearer ones replace it.
            NearestHit bound;
            bound.found = true;
            bound.hit.t = limits[i];
            if (reaches(entry.bounds, rays[i], bound)) asked.add(i, rays[i], bound);
        }
        if (asked.rays.empty()) continue;
        entry.object->shape->nearest(asked.rays, context, asked.nearest);
        for (std::size_t k = 0; k < asked.indices.size(); ++k) {
            const std::uint32_t i = asked.indices[k];
            if (asked.nearest[k].hit.t < limits[i]) blocked[i] = 1;
        }
    }
}

}  // namespace isoscope
