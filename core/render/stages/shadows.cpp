// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/stages/shadows.h"

#include "core/render/light_arrival.h"

namespace isoscope {

namespace {

/// What lies nearer than this to the surface, or to the light, casts no shadow in POV-Ray.
constexpr double shadowTolerance = 1e-3;

/// The shadow rays of a batch and the samples they belong to.
struct ShadowRays {
    std::vector<std::size_t> samples;
    std::vector<Ray> rays;
    std::vector<double> limits;
    std::vector<std::uint8_t> blocked;
};

ShadowRays shadowRays(const SampleBatch& batch, const LightSource& light) {
    ShadowRays result;
    for (std::size_t i = 0; i < batch.size(); ++i) {
        if (batch.arriving[i] == glm::dvec3(0)) continue;
        const LightArrival arrival = lightArrival(light, batch.nearest[i].hit.point);
        result.samples.push_back(i);
        result.rays.push_back({batch.nearest[i].hit.point, arrival.direction});
        result.limits.push_back(arrival.distance - shadowTolerance);
    }
    result.blocked.assign(result.samples.size(), 0);
    return result;
}

}  // namespace

Shadows::Shadows(const Scene& scene)
    : scene_(scene), occluders_(scene, [](const SceneObject& object) { return object.castsShadow; }) {}

void Shadows::filter(TileWork& work, std::size_t light) const {
    if (scene_.lights[light].shadowless) return;
    const StageClock clock(work, StageKind::shadows);
    ShadowRays shadow = shadowRays(work.batch, scene_.lights[light]);
    if (shadow.rays.empty()) return;
    work.meter(StageKind::shadows).rays += shadow.rays.size();
    work.context.shadowRay = true;
    work.context.nearLimit = shadowTolerance;
    occluders_.blocked(shadow.rays, shadow.limits, work.context, shadow.blocked);
    work.context.shadowRay = false;
    work.context.nearLimit = 0;
    for (std::size_t k = 0; k < shadow.samples.size(); ++k)
        if (shadow.blocked[k]) work.batch.arriving[shadow.samples[k]] = glm::dvec3(0);
}

}  // namespace isoscope
