// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/render/effect_reasons.h"
#include "core/render/picture_parts.h"
#include "core/shapes/shape.h"

namespace isoscope {

namespace {

/// Takes away the light of sources with `projected_through` that does not come through their object. What
/// lies beyond the object casts no shadow: SurfacePoints::distance ends there. One ray for each
/// place that such a light would brighten, or for each of its lights where it has an area.
class Projection : public LightFilter {
  public:
    /// The scene must outlive the stage.
    explicit Projection(const Scene& scene) : scene_(scene) {}

    void filter(TileScratch& work, SurfacePoints& points, std::size_t light) const override;

  private:
    const Scene& scene_;
};

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

EffectReason reasonFor(const Scene& scene) {
    const auto light = std::find_if(scene.lights.begin(), scene.lights.end(),
                                    [](const LightSource& each) { return each.projectedThrough != nullptr; });
    if (light == scene.lights.end()) return {false, "no light is projected through an object"};
    return {true, placeOf(*light) + " is projected through an object"};
}

void build(PictureParts& parts) {
    parts.lightFilters->shadows.addFirst(std::make_unique<Projection>(parts.scene()));
}

}  // namespace

const EffectDescription effects::projection{
    .name = "projected light", .reasonFor = reasonFor, .build = build};

}  // namespace isoscope
