// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "core/render/camera/place_random.h"
#include "core/render/effect_reasons.h"
#include "core/render/light/sight_rays.h"
#include "core/render/light/surface_light.h"
#include "core/render/picture_parts.h"
#include "core/texture/color_lookup.h"

namespace isoscope {

namespace {

double angleBetween(const glm::dvec3& a, const glm::dvec3& b) {
    const double lengths = glm::length(a) * glm::length(b);
    if (!(lengths > 0)) return 0;
    return glm::degrees(std::acos(std::clamp(glm::dot(a, b) / lengths, -1.0, 1.0)));
}

/// How much of the arc is left so far from its top.
double arcStrength(const Rainbow& rainbow, double angle) {
    const double whole = rainbow.falloffAngle / 2, end = rainbow.arcAngle / 2;
    if (angle <= whole) return 1;
    if (angle >= end) return 0;
    const double x = (end - angle) / (end - whole);
    return x * x * (3 - 2 * x);
}

/// Lays the scene's rainbows over what the rays see, and dims what later rays will add
/// (SampleBatch::through). Measured on POV-Ray 3.7: what lies behind comes through by the colour's
/// `transmit`, or by exp(-length of the ray / distance) where that is more. Sends no rays.
class RainbowStage : public Stage {
  public:
    /// The request's scene must outlive the stage.
    explicit RainbowStage(const RenderRequest& request);

    void run(TileScratch& work, SampleBatch& batch) const override;

  private:
    class Work;

    const Scene& scene_;
    SightRays sightRays_;
};

/// Where a line of sight meets a rainbow: 0 at its inner edge and 1 at its outer one, and how strongly it
/// shows there, 0 outside of it.
struct RainbowPlace {
    double across = 0;
    double strength = 0;
};
/// The scratch memory of one thread.
class RainbowStage::Work : public ShapeState {
  public:
    explicit Work(std::span<const double> parameters) : lookup(parameters) {}

    ColorLookup lookup;
    // Of the rainbow at hand, by sample.
    std::vector<double> strength;
    std::vector<double> left;  ///< of what lies behind it, by the length of the way
};

/// `sight` is the direction of unit length. Jitter follows from the direction alone, so that a picture is the
/// same on every run.
RainbowPlace placeIn(const Rainbow& rainbow, const glm::dvec3& sight) {
    const double across = (angleBetween(sight, rainbow.direction) - rainbow.angle) / rainbow.width + 0.5;
    const double jitter = rainbow.jitter != 0 ? (2 * PlaceRandom(sight).next() - 1) * rainbow.jitter : 0;
    RainbowPlace place{across + jitter, 0};
    if (!(place.across >= 0 && place.across <= 1)) return place;
    const glm::dvec3 axis = glm::normalize(rainbow.direction);
    const auto beside = [&](const glm::dvec3& v) { return v - glm::dot(v, axis) * axis; };
    place.strength = arcStrength(rainbow, angleBetween(beside(sight), beside(rainbow.up)));
    return place;
}

RainbowStage::RainbowStage(const RenderRequest& request) : scene_(*request.scene), sightRays_(request) {}

void RainbowStage::run(TileScratch& work, SampleBatch& batch) const {
    Work& own =
        work.context.state<Work>(this, [&] { return std::make_unique<Work>(work.context.parameters()); });
    if (batch.through.empty()) batch.through.assign(batch.size(), glm::dvec3(1));
    work.distances.assign(batch.size(), HitBatch::never);
    for (std::size_t i = 0; i < batch.rays.size(); ++i)
        work.distances[batch.rays.samples()[i]] = batch.hits[HitBatch::t][i];
    const RayBatch& rays = sightRays_.of(batch);
    for (const Rainbow& rainbow : scene_.rainbows) {
        own.strength.assign(batch.size(), 0);
        own.left.assign(batch.size(), 1);
        const auto lay = [&](std::size_t sample, const Color& color) {
            // As with fog: what the colour lets through comes through on any way.
            const double clear = 1 - own.strength[sample] * (1 - color.transmit);
            const double opacity = 1 - std::max(own.left[sample], clear);
            batch.colors[sample] = rgb(color) * opacity + batch.colors[sample] * (1 - opacity);
            batch.through[sample] *= 1 - opacity;
        };
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const Ray ray = rays.ray(i);
            if (ray.direction == glm::dvec3(0)) continue;
            const RainbowPlace place = placeIn(rainbow, glm::normalize(ray.direction));
            const double depth = work.distances[ray.sample] / rainbow.distance;
            if (!(place.strength > 0)) continue;
            own.strength[ray.sample] = place.strength;
            own.left[ray.sample] = std::exp(-depth);
            if (rainbow.colors.pigmentTape)
                own.lookup.ask(rainbow.colors, {place.across, 0, 0}, ray.sample);
            else
                lay(ray.sample, std::get<SolidPigment>(rainbow.colors.pigment).color);
        }
        work.context.evaluations += own.lookup.answer(lay);
    }
    work.charge(StageKind::rainbow);
}

EffectReason reasonFor(const Scene& scene) {
    if (scene.rainbows.empty()) return {false, "there is no rainbow"};
    const int line = scene.rainbows.front().line;
    return {true, (line > 0 ? "rainbow at line " + std::to_string(line) : "a rainbow") + "; " +
                      counted(scene.rainbows.size(), "rainbow") + " in all"};
}

void build(PictureParts& parts) { parts.addStage(std::make_unique<RainbowStage>(parts.request)); }

}  // namespace

const EffectDescription effects::rainbow{.name = "rainbow", .reasonFor = reasonFor, .build = build};

}  // namespace isoscope
