// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/stages/fog_on_light.h"

#include <algorithm>
#include <cmath>

#include "core/render/light/fog_depth.h"

namespace isoscope {

bool FogOnLight::concerns(const Scene& scene) {
    return std::any_of(scene.lights.begin(), scene.lights.end(),
                       [](const LightSource& light) { return light.mediaAttenuation; }) &&
           std::any_of(scene.fogs.begin(), scene.fogs.end(),
                       [](const Fog& fog) { return fog.distance != 0; });
}

void FogOnLight::filter(TileScratch& work, SurfacePoints& points, std::size_t light) const {
    if (!scene_.lights[light].mediaAttenuation) return;
    auto& own =
        work.context.state<FogLookup::Work>(this, [&] { return fogs_.makeWork(work.context.parameters()); });
    fogs_.begin(own);
    for (std::size_t k = 0; k < points.size(); ++k)
        fogs_.add({at(points.point, k), at(points.toLight, k)}, points.distance[k], own);
    work.context.evaluations += fogs_.findTurbulence(own);
    for (std::size_t k = 0; k < points.size(); ++k) {
        glm::dvec3 through(1);
        for (std::size_t fog = 0; fog < scene_.fogs.size(); ++fog) {
            if (scene_.fogs[fog].distance == 0) continue;
            const double left = fogs_.left(fog, k, own);
            if (std::isfinite(left)) through *= filteredByFog(scene_.fogs[fog], left);
        }
        for (std::size_t c = 0; c < 3; ++c) points.returned[c][k] *= through[static_cast<int>(c)];
    }
    work.charge(StageKind::fog);
}

}  // namespace isoscope
