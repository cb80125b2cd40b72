// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/stages/sky.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/render/light/surface_light.h"
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

}  // namespace

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

}  // namespace isoscope
