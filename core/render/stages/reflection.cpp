// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include "core/image/brightness.h"
#include "core/render/camera/crossing.h"
#include "core/render/camera/mirror.h"
#include "core/render/effect_reasons.h"
#include "core/render/light/reflectance.h"
#include "core/render/light/secondary_ray_queue.h"
#include "core/render/picture_parts.h"

namespace isoscope {

namespace {

/// Sends rays to where surfaces with `reflection` mirror: what they see is added to the samples.
class Reflection : public Stage {
  public:
    /// The scene must outlive the stage.
    explicit Reflection(const Scene& scene);

    void run(TileScratch& work, SampleBatch& batch) const override;

  private:
    void mirror(std::size_t point, const Material& material, SampleBatch& batch, TileScratch& work) const;
    glm::dvec3 throughFilm(const SurfacePoints& points, std::size_t point, const Material& material,
                           const glm::dvec3& direction) const;

    const Scene& scene_;
    SecondaryRayQueue sender_;
};

Reflection::Reflection(const Scene& scene) : scene_(scene), sender_(scene.settings) {}

void Reflection::run(TileScratch& work, SampleBatch& batch) const {
    const SurfacePoints& points = batch.points;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const MaterialId id = points.materials[k];
        if (id < 0 || static_cast<std::size_t>(id) >= scene_.materials.size()) continue;
        const Material& material = scene_.materials[static_cast<std::size_t>(id)];
        if (material.finish.reflects()) mirror(k, material, batch, work);
    }
    work.charge(StageKind::reflection);
}

glm::dvec3 Reflection::throughFilm(const SurfacePoints& points, std::size_t k, const Material& material,
                                   const glm::dvec3& direction) const {
    const double thickness = material.filmTape ? points.film[k] : material.finish.iridThickness;
    const double cosines = glm::dot(facingNormal(points, k, material), direction - at(points.view, k));
    const glm::dvec3 share =
        filmShare(material.finish, thickness, cosines, rgb(scene_.settings.iridWavelength));
    // The film lies before the exponent, as in POV-Ray (measured).
    const double exponent = material.finish.reflectionExponent;
    return exponent == 1 || !(exponent > 0) ? share
                                            : glm::pow(glm::max(share, 0.0), glm::dvec3(1 / exponent));
}

void Reflection::mirror(std::size_t k, const Material& material, SampleBatch& batch,
                        TileScratch& work) const {
    const SurfacePoints& points = batch.points;
    const std::uint32_t sample = points.samples[k];
    if (!batch.mirrored.empty() && batch.mirrored[sample]) return;
    const LightPath& path = batch.path(sample);
    SecondaryRayRequest glance;
    glance.weight = reflectanceAt(scene_, material, points, k, path);
    if (points.weighted && points.share[k] > 0) {
        glance.weight *= points.share[k];
        // What layers above let through counts for adc_bailout alone, as in POV-Ray.
        const glm::dvec3 through = at(points.weight, k) / points.share[k];
        glance.seen = brightness(through.x, through.y, through.z);
    } else if (points.weighted) {
        return;
    }
    glance.sample = sample;
    glance.ray = {at(points.point, k), mirrored(points, k, material)};
    if (material.finish.irid != 0) glance.weight *= throughFilm(points, k, material, glance.ray.direction);
    glance.sender = StageKind::reflection;
    glance.inside = path.inside;
    glance.reflected = true;
    glance.exponent = material.finish.reflectionExponent;
    sender_.send(glance, batch, work);
}

EffectReason reasonFor(const Scene& scene) {
    return reasonOfObjects(
        scene, [](const SceneObject& object) { return isSeen(object) && object.reflective; }, "mirrors",
        "no finish has reflection");
}

void build(PictureParts& parts) {
    parts.addStage(std::make_unique<Reflection>(parts.scene()));
    parts.sendsRays = true;
    parts.knowsInteriors = true;
}

}  // namespace

const EffectDescription effects::reflection{.name = "reflection", .reasonFor = reasonFor, .build = build};

}  // namespace isoscope
