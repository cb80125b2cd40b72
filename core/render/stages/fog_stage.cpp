// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "core/render/effect_reasons.h"
#include "core/render/light/fog_depth.h"
#include "core/render/light/fog_lookup.h"
#include "core/render/light/sight_rays.h"
#include "core/render/light/surface_light.h"
#include "core/render/picture_parts.h"
#include "core/render/stages/fog_on_light.h"

namespace isoscope {

namespace {

/// Lays the scene's fogs over what the rays see, background and sky included, and dims what later rays will
/// add (SampleBatch::through). Inside of objects that are not hollow there is no fog. Sends no rays.
class FogStage : public Stage {
  public:
    /// The request's scene must outlive the stage.
    explicit FogStage(const RenderRequest& request);

    void run(TileScratch& work, SampleBatch& batch) const override;

  private:
    bool reaches(const InteriorList& inside) const;
    /// Lays all fogs over what is seen on a way.
    void lay(std::size_t way, std::uint32_t sample, const FogLookup::Work& own, SampleBatch& batch) const;

    const Scene& scene_;
    FogLookup fogs_;
    SightRays sightRays_;
};

FogStage::FogStage(const RenderRequest& request)
    : scene_(*request.scene), fogs_(scene_), sightRays_(request) {}

void FogStage::run(TileScratch& work, SampleBatch& batch) const {
    auto& own =
        work.context.state<FogLookup::Work>(this, [&] { return fogs_.makeWork(work.context.parameters()); });
    if (batch.through.empty()) batch.through.assign(batch.size(), glm::dvec3(1));
    work.distances.assign(batch.size(), HitBatch::never);
    for (std::size_t i = 0; i < batch.rays.size(); ++i)
        work.distances[batch.rays.samples()[i]] = batch.hits[HitBatch::t][i];
    const RayBatch& rays = sightRays_.of(batch);
    fogs_.begin(own);
    for (std::size_t i = 0; i < rays.size(); ++i)
        fogs_.add(rays.ray(i), work.distances[rays.samples()[i]], own);
    work.context.evaluations += fogs_.findTurbulence(own);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Ray ray = rays.ray(i);
        // Beside a round picture nothing is seen, no fog either.
        if (ray.direction != glm::dvec3(0) && reaches(batch.path(ray.sample).inside))
            lay(i, ray.sample, own, batch);
    }
    work.charge(StageKind::fog);
}

bool FogStage::reaches(const InteriorList& inside) const {
    return std::all_of(inside.all().begin(), inside.all().end(),
                       [&](InteriorId id) { return scene_.interiors[static_cast<std::size_t>(id)].hollow; });
}

/// As in POV-Ray, fogs do not dim each other's haze.
void FogStage::lay(std::size_t way, std::uint32_t sample, const FogLookup::Work& own,
                   SampleBatch& batch) const {
    glm::dvec3 haze(0), through(1);
    for (std::size_t number = 0; number < scene_.fogs.size(); ++number) {
        const Fog& fog = scene_.fogs[number];
        if (fog.distance == 0) continue;
        const double left = fogs_.left(number, way, own);
        if (!std::isfinite(left)) continue;
        through *= filteredByFog(fog, left);
        haze += rgb(fog.color) * (1 - left);
    }
    glm::dvec3& color = batch.colors[sample];
    // Endless light that does not come through is none.
    for (int c = 0; c < 3; ++c) color[c] = haze[c] + (through[c] > 0 ? through[c] * color[c] : 0);
    batch.through[sample] *= through;
}

EffectReason reasonFor(const Scene& scene) {
    const auto fog = std::find_if(scene.fogs.begin(), scene.fogs.end(),
                                  [](const Fog& each) { return each.distance != 0; });
    if (fog == scene.fogs.end()) return {false, "there is no fog"};
    const std::string place = fog->line > 0 ? "fog at line " + std::to_string(fog->line) : "a fog";
    return {true, place + "; " + counted(scene.fogs.size(), "fog") + " in all"};
}

void build(PictureParts& parts) {
    parts.addStage(std::make_unique<FogStage>(parts.request));
    parts.knowsInteriors = true;
    if (FogOnLight::concerns(parts.scene()))
        parts.lightFilters->behind.add(std::make_unique<FogOnLight>(parts.scene()));
}

}  // namespace

const EffectDescription effects::fog{.name = "fog", .reasonFor = reasonFor, .build = build};

}  // namespace isoscope
