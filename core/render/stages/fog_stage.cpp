// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/stages/fog_stage.h"

#include <algorithm>
#include <cmath>

#include "core/render/fog_depth.h"
#include "core/render/surface_light.h"

namespace isoscope {

FogStage::FogStage(const RenderRequest& request) : scene_(*request.scene), sightRays_(request) {}

void FogStage::run(TileWork& work, SampleBatch& batch) const {
    batch.through.assign(batch.size(), glm::dvec3(1));
    work.distances.assign(batch.size(), HitBatch::never);
    for (std::size_t i = 0; i < batch.rays.size(); ++i)
        work.distances[batch.rays.samples()[i]] = batch.hits[HitBatch::t][i];
    const RayBatch& rays = sightRays_.of(batch);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Ray ray = rays.ray(i);
        // Beside a round picture nothing is seen, no fog either.
        if (ray.direction == glm::dvec3(0) || !reaches(batch.path(ray.sample).inside)) continue;
        glm::dvec3 haze(0), through(1);
        for (const Fog& fog : scene_.fogs) lay(fog, ray, work.distances[ray.sample], haze, through);
        glm::dvec3& color = batch.colors[ray.sample];
        // Endless light that does not come through is none.
        for (int c = 0; c < 3; ++c) color[c] = haze[c] + (through[c] > 0 ? through[c] * color[c] : 0);
        batch.through[ray.sample] = through;
    }
    work.charge(StageKind::fog);
}

bool FogStage::reaches(const InteriorList& inside) const {
    return std::all_of(inside.all().begin(), inside.all().end(),
                       [&](InteriorId id) { return scene_.interiors[static_cast<std::size_t>(id)].hollow; });
}

/// As in POV-Ray, fogs do not dim each other's haze.
void FogStage::lay(const Fog& fog, const Ray& ray, double distance, glm::dvec3& haze,
                   glm::dvec3& through) const {
    if (fog.distance == 0) return;
    const double left = leftByFog(fog, ray, distance, scene_.settings.noiseGenerator);
    if (!std::isfinite(left)) return;
    through *= filteredByFog(fog, left);
    haze += rgb(fog.color) * (1 - left);
}

}  // namespace isoscope
