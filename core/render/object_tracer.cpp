// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/object_tracer.h"

#include <algorithm>
#include <cstdint>

namespace isoscope {

namespace {

bool reaches(const Bounds& bounds, const Ray& ray, const NearestHit& soFar) {
    const RayInterval inside = bounds.clip(ray);
    return !inside.empty() && !(soFar.found && inside.near > soFar.hit.t);
}

}  // namespace

bool ObjectTracer::mayMeet(const RayBundle& rays) const {
    return std::any_of(objects_.begin(), objects_.end(),
                       [&](const Entry& entry) { return entry.mayMeet(rays); });
}

void ObjectTracer::nearest(std::span<const Ray> rays, TraceContext& context, GatheredRays& asked,
                           std::span<NearestHit> nearest) const {
    for (NearestHit& hit : nearest) hit.found = false;
    if (rays.empty()) return;
    // The only object of a scene finds out by itself which rays come near it.
    if (objects_.size() == 1) {
        objects_[0].object->shape->nearest(rays, context, nearest);
        return claim(objects_[0], nearest);
    }
    const RayBundle bundle(rays);
    for (const Entry& entry : objects_) {
        if (!entry.mayMeet(bundle)) continue;
        asked.clear();
        for (std::size_t i = 0; i < rays.size(); ++i)
            if (reaches(entry.bounds, rays[i], nearest[i])) asked.add(i, rays[i], nearest[i]);
        if (asked.rays.empty()) continue;
        entry.object->shape->nearest(asked.rays, context, asked.nearest);
        for (std::size_t k = 0; k < asked.indices.size(); ++k)
            if (asked.nearest[k].found) nearest[asked.indices[k]] = asked.nearest[k];
        claim(entry, nearest);
    }
}

/// The hits of the objects before have their materials.
void ObjectTracer::claim(const Entry& entry, std::span<NearestHit> nearest) {
    for (NearestHit& hit : nearest)
        if (hit.found && hit.hit.material == noMaterial) hit.hit.material = entry.object->material;
}

void ObjectTracer::blocked(std::span<const Ray> rays, std::span<const double> limits, TraceContext& context,
                           GatheredRays& asked, std::span<std::uint8_t> blocked) const {
    std::fill(blocked.begin(), blocked.end(), 0);
    const RayBundle bundle(rays);
    for (const Entry& entry : objects_) {
        if (!entry.mayMeet(bundle)) continue;
        asked.clear();
        for (std::size_t i = 0; i < rays.size(); ++i) {
            if (blocked[i]) continue;
            // A hit at the light is given beforehand: only nearer ones replace it.
            NearestHit bound;
            bound.found = true;
            bound.hit.t = limits[i];
            if (objects_.size() == 1 || reaches(entry.bounds, rays[i], bound)) asked.add(i, rays[i], bound);
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
