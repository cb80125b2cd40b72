// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/stages/fog_on_light.h"

#include <algorithm>
#include <cmath>

#include "core/render/fog_depth.h"

namespace isoscope {

bool FogOnLight::concerns(const Scene& scene) {
    return std::any_of(scene.lights.begin(), scene.lights.end(),
                       [](const LightSource& light) { return light.mediaAttenuation; }) &&
           std::any_of(scene.fogs.begin(), scene.fogs.end(),
                       [](const Fog& fog) { return fog.distance != 0; });
}

void FogOnLight::filter(TileWork& work, SurfacePoints& points, std::size_t light) const {
    if (!scene_.lights[light].mediaAttenuation) return;
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (at(points.returned, k) == glm::dvec3(0)) continue;
        const Ray ray{at(points.point, k), at(points.toLight, k)};
        glm::dvec3 through(1);
        for (const Fog& fog : scene_.fogs) {
            if (fog.distance == 0) continue;
            const double left = leftByFog(fog, ray, points.distance[k], scene_.settings.noiseGenerator);
            if (std::isfinite(left)) through *= filteredByFog(fog, left);
        }
        for (std::size_t c = 0; c < 3; ++c) points.returned[c][k] *= through[static_cast<int>(c)];
    }
    work.charge(StageKind::fog);
}

}  // namespace isoscope
