// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/render/camera/place_random.h"
#include "core/render/effect_reasons.h"
#include "core/render/light/surface_light.h"
#include "core/render/picture_parts.h"

namespace isoscope {

namespace {

glm::dvec3 pigmentAt(const Material& material, const SurfacePoints& points, std::size_t k) {
    if (material.pigmentTape || points.weighted) return at(points.pigment, k);
    const auto* solid = std::get_if<SolidPigment>(&material.pigment);
    return solid ? rgb(solid->color) : glm::dvec3(0);
}

/// Whether the surface returns some of a light by `diffuse` (findReturned).
bool returnsByDiffuse(const Material& material, const SurfacePoints& points, std::size_t k) {
    const glm::dvec3 normal = at(points.normal, k);
    const bool turned = !material.normalTape && glm::dot(normal, at(points.view, k)) > 0;
    const double cosine = glm::dot(normal, at(points.toLight, k)) * (turned ? -1 : 1);
    return cosine > 0 && material.finish.diffuse > 0;
}

/// `crand`: surfaces that return less of each light at random, as if they were grainy. POV-Ray takes up to
/// `crand` off the diffuse part, the same of all channels, down to negative light (measured on its pictures).
/// Here the grain depends on the place alone, so that a picture is the same each time. Stands before the
/// shadows. Sends no rays.
class Grain : public LightFilter {
  public:
    /// The scene must outlive the stage.
    explicit Grain(const Scene& scene) : scene_(scene) {}

    void filter(TileScratch& work, SurfacePoints& points, std::size_t light) const override;

  private:
    const Scene& scene_;
};

void Grain::filter(TileScratch& work, SurfacePoints& points, std::size_t light) const {
    const glm::dvec3 color = rgb(scene_.lights[light].color);
    work.charge(StageKind::directLight);
    for (std::size_t k = 0; k < points.size(); ++k) {
        const auto id = static_cast<std::size_t>(points.materials[k]);
        if (points.materials[k] < 0 || id >= scene_.materials.size()) continue;
        const Material& material = scene_.materials[id];
        if (!(material.finish.crand > 0) || !returnsByDiffuse(material, points, k)) continue;
        const double loss = material.finish.crand * PlaceRandom(at(points.point, k), light).next();
        const glm::dvec3 lost = loss * points.strength[k] * color * pigmentAt(material, points, k);
        for (int c = 0; c < 3; ++c) points.returned[static_cast<std::size_t>(c)][k] -= lost[c];
    }
    work.charge(StageKind::grain);
}

EffectReason reasonFor(const Scene& scene) {
    const auto grainy = [](const Material& material) { return material.finish.crand > 0; };
    const auto count = std::count_if(scene.materials.begin(), scene.materials.end(), grainy);
    if (count == 0) return {false, "no finish has crand"};
    if (scene.lights.empty()) return {false, "there is no light"};
    return {true, counted(static_cast<std::size_t>(count), "material") + " with crand"};
}

void build(PictureParts& parts) {
    parts.lightFilters->before.addFirst(std::make_unique<Grain>(parts.scene()));
}

}  // namespace

const EffectDescription effects::grain{.name = "grain", .reasonFor = reasonFor, .build = build};

}  // namespace isoscope
