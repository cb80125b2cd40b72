// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "core/shapes/shape.h"

namespace isoscope {

/// Puts the hits from `first` on into the order of t; equal t keep their order.
void sortHits(HitList& hits, std::size_t first);

/// Removes, from `first` on, the hits for which keep(hit) is false.
template <class Keep>
void keepHits(HitList& hits, std::size_t first, Keep keep) {
    std::size_t kept = first;
    for (std::size_t i = first; i < hits.size(); ++i)
        if (keep(hits[i])) hits[kept++] = hits[i];
    hits.resize(kept);
}

/// Takes `hit` when nothing nearer is known.
inline void offer(const Hit& hit, NearestHit& nearest) {
    if (!nearest.found || hit.t < nearest.hit.t) nearest = {true, hit};
}

/// Shape::nearest by way of shape.allHits(), for shapes that decide about hits only after they are found.
void nearestOfAll(const Shape& shape, std::span<const Ray> rays, TraceContext& context,
                  std::span<NearestHit> nearest);

/// unitNormal() where the square of a component may overflow or vanish.
glm::dvec3 scaledUnitNormal(const glm::dvec3& normal);

/// `normal` with unit length; (1, 0, 0), POV-Ray's answer, when it has none or is not a number.
inline glm::dvec3 unitNormal(const glm::dvec3& normal) {
    const double square = glm::dot(normal, normal);
    if (square > 1e-200 && square < 1e200) return normal / std::sqrt(square);
    return scaledUnitNormal(normal);
}

/// Shape::nearest for shapes that trace one ray at a time: trace(ray, interval, hits) adds the first hit of
/// the interval to an empty list, and perhaps later ones.
template <class Trace>
void traceOneByOne(std::span<const Ray> rays, double nearLimit, std::span<NearestHit> nearest, Trace trace) {
    HitList hits;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        hits.clear();
        trace(rays[i], RayInterval{nearLimit, nearest[i].found ? nearest[i].hit.t : RayInterval().far}, hits);
        for (const Hit& hit : hits) offer(hit, nearest[i]);
    }
}

}  // namespace isoscope
