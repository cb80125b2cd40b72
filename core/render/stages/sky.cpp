// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/render/effect_reasons.h"
#include "core/render/light/sight_rays.h"
#include "core/render/light/surface_light.h"
#include "core/render/picture_parts.h"
#include "core/texture/color_lookup.h"

namespace isoscope {

namespace {

/// The scratch memory of one thread.
class SkyWork : public ShapeState {
  public:
    explicit SkyWork(std::span<const double> parameters) : lookup(parameters) {}

    ColorLookup lookup;
    std::vector<std::uint8_t> hit;
    std::vector<glm::dvec3> through, sum;
};

/// Paints the samples whose rays have met nothing with the sky_sphere of the scene, over the background.
class Sky : public Stage {
  public:
    /// The request's scene has a sky and must outlive the stage.
    explicit Sky(const RenderRequest& request);

    void run(TileScratch& work, SampleBatch& batch) const override;

  private:
    const SkySphere& sky_;
    glm::dvec3 background_;
    SightRays sightRays_;
};

Sky::Sky(const RenderRequest& request)
    : sky_(*request.scene->sky), background_(rgb(request.scene->background)), sightRays_(request) {}

void Sky::run(TileScratch& work, SampleBatch& batch) const {
    SkyWork& own = work.context.state<SkyWork>(
        this, [&] { return std::make_unique<SkyWork>(work.context.parameters()); });
    own.hit.assign(batch.size(), 0);
    for (const std::uint32_t sample : batch.points.samples) own.hit[sample] = 1;
    if (std::find(own.hit.begin(), own.hit.end(), 0) == own.hit.end()) return work.charge(StageKind::sky);
    const RayBatch& rays = sightRays_.of(batch);
    own.through.assign(batch.size(), glm::dvec3(1));
    own.sum.assign(batch.size(), glm::dvec3(0));
    for (auto layer = sky_.layers.rbegin(); layer != sky_.layers.rend(); ++layer) {
        const auto lay = [&](std::size_t sample, const Color& color) {
            const glm::dvec3 pigment = rgb(color);
            const double opacity = 1 - std::clamp(color.filter + color.transmit, 0.0, 1.0);
            own.sum[sample] += own.through[sample] * pigment * opacity;
            own.through[sample] *= pigment * color.filter + glm::dvec3(color.transmit);
        };
        if (layer->pigmentTape) {
            for (std::size_t i = 0; i < rays.size(); ++i) {
                const Ray ray = rays.ray(i);
                if (!own.hit[ray.sample]) own.lookup.ask(*layer, glm::normalize(ray.direction), ray.sample);
            }
            work.context.evaluations += own.lookup.answer(lay);
            continue;
        }
        for (std::size_t sample = 0; sample < batch.size(); ++sample)
            if (!own.hit[sample]) lay(sample, std::get<SolidPigment>(layer->pigment).color);
    }
    const glm::dvec3 emission = rgb(sky_.emission);
    for (std::size_t sample = 0; sample < batch.size(); ++sample)
        if (!own.hit[sample])
            batch.colors[sample] = own.sum[sample] * emission + own.through[sample] * background_;
    work.charge(StageKind::sky);
}

EffectReason reasonFor(const Scene& scene) {
    if (!scene.sky || scene.sky->layers.empty()) return {false, "there is no sky_sphere"};
    return {true, "a sky_sphere with " + counted(scene.sky->layers.size(), "pigment")};
}

void build(PictureParts& parts) { parts.addStage(std::make_unique<Sky>(parts.request)); }

}  // namespace

const EffectDescription effects::sky{.name = "sky", .reasonFor = reasonFor, .build = build};

}  // namespace isoscope
