// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/stages/projection.h"

#include "core/shapes/shape.h"

namespace isoscope {

void Projection::filter(TileScratch& work, SurfacePoints& points, std::size_t light) const {
    const Shape* shape = scene_.lights[light].projectedThrough.get();
    if (!shape) return;
    std::vector<Ray> rays;
    std::vector<std::size_t> places;
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (at(points.returned, k) == glm::dvec3(0)) continue;
        places.push_back(k);
        rays.push_back({at(points.point, k), at(points.toLight, k)});
    }
    work.meter(StageKind::projection).rays += rays.size();
    const bool missMemory = work.context.missMemory;
    work.context.missMemory = false;
    std::vector<NearestHit> nearest(rays.size());
    shape->nearest(rays, work.context, nearest);
    work.context.missMemory = missMemory;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const std::size_t k = places[i];
        if (nearest[i].found && nearest[i].hit.t < points.distance[k])
            points.distance[k] = nearest[i].hit.t;
        else
            for (SurfacePoints::Column& column : points.returned) column[k] = 0;
    }
    work.charge(StageKind::projection);
}

}  // namespace isoscope
