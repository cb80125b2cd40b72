// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string>

#include "core/render/effect_reasons.h"
#include "core/render/light/media_march.h"
#include "core/render/light/sight_rays.h"
#include "core/render/picture_parts.h"

namespace isoscope {

namespace {

/// Lays media over what the rays see, background and sky included, and dims what later rays will add
/// (SampleBatch::through). Shadow rays that it asks for count as those of surfaces.
class MediaStage : public Stage {
  public:
    /// The request's scene must outlive the stage.
    MediaStage(const RenderRequest& request, std::shared_ptr<const LightFilters> filters)
        : media_(*request.scene, {}, std::move(filters)), sightRays_(request) {}

    void run(TileScratch& work, SampleBatch& batch) const override;

  private:
    MediaMarch media_;
    SightRays sightRays_;
};

void MediaStage::run(TileScratch& work, SampleBatch& batch) const {
    auto& own = work.context.state<MediaMarch::Work>(
        this, [&] { return std::make_unique<MediaMarch::Work>(work.context.parameters()); });
    if (batch.through.empty()) batch.through.assign(batch.size(), glm::dvec3(1));
    work.distances.assign(batch.size(), HitBatch::never);
    for (std::size_t i = 0; i < batch.rays.size(); ++i)
        work.distances[batch.rays.samples()[i]] = batch.hits[HitBatch::t][i];
    const RayBatch& rays = sightRays_.of(batch);
    own.ways.clear();
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Ray ray = rays.ray(i);
        const InteriorList& inside = batch.path(ray.sample).inside;
        // Beside a round picture nothing is seen.
        if (ray.direction == glm::dvec3(0) || !media_.fills(inside)) continue;
        own.ways.push_back({ray, work.distances[ray.sample], inside, ray.sample});
    }
    work.lit = &batch;
    media_.find(work, own);
    for (const MediaMarch::Way& way : own.ways) {
        glm::dvec3& color = batch.colors[way.sample];
        // Endless light that does not come through is none.
        for (int c = 0; c < 3; ++c)
            color[c] = way.light[c] + (way.through[c] > 0 ? way.through[c] * color[c] : 0);
        batch.through[way.sample] *= way.through;
    }
    work.charge(StageKind::media);
}

/// Dims the light of sources with `media_attenuation` by the media of all space, between source and surface.
/// Those of objects are on the way of ClearShadows. Sends no rays.
class MediaOnLight : public LightFilter {
  public:
    /// The scene must outlive it.
    explicit MediaOnLight(const Scene& scene) : scene_(scene), media_(scene, {true, false}, nullptr) {}

    void filter(TileScratch& work, SurfacePoints& points, std::size_t light) const override;

    /// Whether the scene calls for it.
    static bool concerns(const Scene& scene) {
        return !scene.atmosphere.empty() && std::ranges::any_of(scene.lights, [](const LightSource& light) {
            return light.mediaAttenuation;
        });
    }

  private:
    const Scene& scene_;
    MediaMarch media_;
};

void MediaOnLight::filter(TileScratch& work, SurfacePoints& points, std::size_t light) const {
    if (!scene_.lights[light].mediaAttenuation) return;
    auto& own = work.context.state<MediaMarch::Work>(
        this, [&] { return std::make_unique<MediaMarch::Work>(work.context.parameters()); });
    own.ways.clear();
    for (std::size_t k = 0; k < points.size(); ++k)
        if (at(points.returned, k) != glm::dvec3(0))
            own.ways.push_back({{at(points.point, k), at(points.toLight, k)},
                                points.distance[k],
                                {},
                                static_cast<std::uint32_t>(k)});
    media_.find(work, own);
    for (const MediaMarch::Way& way : own.ways)
        for (std::size_t c = 0; c < 3; ++c)
            points.returned[c][way.sample] *= way.through[static_cast<int>(c)];
    work.charge(StageKind::media);
}

EffectReason reasonFor(const Scene& scene) {
    const auto reason = [](const Medium& medium, const char* where) {
        const std::string place = medium.line > 0 ? "media at line " + std::to_string(medium.line) : "media";
        return EffectReason{true, place + " " + where};
    };
    if (!scene.atmosphere.empty()) return reason(*scene.atmosphere.front(), "fill all space");
    for (const Interior& interior : scene.interiors)
        if (interior.hollow && !interior.media.empty())
            return reason(*interior.media.front(), "fill an object");
    return {false, "no hollow object has media"};
}

void build(PictureParts& parts) {
    parts.addStage(std::make_unique<MediaStage>(parts.request, parts.lightFilters));
    parts.knowsInteriors = true;
    if (MediaOnLight::concerns(parts.scene()))
        parts.lightFilters->behind.add(std::make_unique<MediaOnLight>(parts.scene()));
}

}  // namespace

const EffectDescription effects::media{
    .name = "media",
    .reasonFor = reasonFor,
    .build = build,
    .leftOutNote = "; without it smoke, glow and haze are missing",
};

}  // namespace isoscope
