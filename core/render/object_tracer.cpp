// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/object_tracer.h"

#include <cstdint>

#include "core/render/ray_bundle.h"

namespace isoscope {

namespace {

/// The rays that one object is asked about, gathered so that it sees a dense list.
struct Gathered {
    std::vector<std::uint32_t> indices;
    std::vector<Ray> rays;
    std::vector<NearestHit> nearest;

    void clear() {
        indices.clear();
        rays.clear();
        nearest.clear();
    }
    void add(std::size_t index, const Ray& ray, const NearestHit& bound) {
        indices.push_back(static_cast<std::uint32_t>(index));
        rays.push_back(ray);
        nearest.push_back(bound);
    }
};

bool reaches(const Bounds& bounds, const Ray& ray, const NearestHit& soFar) {
    const RayInterval inside = bounds.clip(ray);
    return !inside.empty() && !(soFar.found && inside.near > soFar.hit.t);
}

}  // namespace

void ObjectTracer::nearest(std::span<const Ray> rays, TraceContext& context,
                           std::span<NearestHit> nearest) const {
    Gathered asked;
    const RayBundle bundle(rays);
    for (const Entry& entry : objects_) {
        if (!bundle.mayMeet(entry.bounds)) continue;
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
                           std::span<std::uint8_t> blocked) const {
    Gathered asked;
    const RayBundle bundle(rays);
    for (const Entry& entry : objects_) {
        if (!bundle.mayMeet(entry.bounds)) continue;
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
