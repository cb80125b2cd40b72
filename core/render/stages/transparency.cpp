// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/stages/transparency.h"

#include <cmath>

#include "core/render/camera/mirror.h"
#include "core/render/effect_reasons.h"
#include "core/render/light/transmission.h"
#include "core/render/picture_parts.h"

namespace isoscope {

namespace {

/// Turns a ray by Snell's law; false when nothing comes through. The normal may point to either side: those
/// of textures may be bent away from the viewer.
bool bend(const Crossing& crossing, const glm::dvec3& normal, glm::dvec3& direction) {
    const double ratio = crossing.before / crossing.after;
    const double along = glm::dot(direction, normal);
    const double square = 1 - ratio * ratio * (1 - along * along);
    if (!(square >= 0)) return false;
    const double change = std::copysign(std::sqrt(square), along) - ratio * along;
    const glm::dvec3 bent = ratio * direction + change * normal;
    const double length = glm::length(bent);
    if (length > 0 && std::isfinite(length)) direction = bent / length;
    return true;
}

}  // namespace

Transparency::Transparency(const Scene& scene, bool refraction)
    : scene_(scene), sender_(scene.settings), refraction_(refraction) {}

void Transparency::run(TileScratch& work, SampleBatch& batch) const {
    const SurfacePoints& points = batch.points;
    Surface surface;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const bool sameRay = k > 0 && points.samples[k] == points.samples[k - 1];
        const bool sameNormal = at(points.normal, k) == at(points.normal, surface.first);
        if (!sameRay || (points.outermost[k] && !sameNormal)) {
            send(surface, batch, work);
            surface = {k};
        }
        surface.transmission += transmissionOf(batch, k);
    }
    send(surface, batch, work);
    work.charge(StageKind::transparency);
}

const Material* Transparency::materialOf(const SurfacePoints& points, std::size_t k) const {
    const MaterialId id = points.materials[k];
    return id >= 0 && static_cast<std::size_t>(id) < scene_.materials.size()
               ? &scene_.materials[static_cast<std::size_t>(id)]
               : nullptr;
}

glm::dvec3 Transparency::transmissionOf(const SampleBatch& batch, std::size_t k) const {
    const SurfacePoints& points = batch.points;
    const Material* material = materialOf(points, k);
    if (!material) return glm::dvec3(0);
    const glm::dvec3 all = transmissionAt(*material, points, k);
    // Of layers it is counted already.
    if (points.weighted || !material->finish.conserveEnergy || !material->finish.reflects()) return all;
    return all * (glm::dvec3(1) - reflectanceAt(scene_, *material, points, k, batch.path(points.samples[k])));
}

void Transparency::send(const Surface& surface, SampleBatch& batch, TileScratch& work) const {
    if (surface.transmission == glm::dvec3(0)) return;
    const SurfacePoints& points = batch.points;
    const Material& material = *materialOf(points, surface.first);
    const LightPath& path = batch.path(points.samples[surface.first]);
    const Crossing crossing = crossingAt(scene_, path, material);
    SecondaryRayRequest glance;
    glance.sample = points.samples[surface.first];
    if (crossing.leaves) {
        const Interior& left = scene_.interiors[static_cast<std::size_t>(material.interior)];
        const glm::dvec3 place = at(points.point, surface.first);
        if (left.fades()) glance.weight = fading(left, glm::distance(batch.origin(glance.sample), place));
    }
    glance.ray = {at(points.point, surface.first), at(points.view, surface.first)};
    glance.sender = StageKind::transparency;
    glance.inside = crossing.beyond;
    glance.straight = true;
    const bool disperses = !path.dispersed && material.interior != noInterior &&
                           scene_.interiors[static_cast<std::size_t>(material.interior)].dispersion != 1;
    if (refraction_ && disperses) return sendSpectrum(surface, path, glance, batch, work);
    if (refraction_ && crossing.before != crossing.after) return sendBent(surface, path, glance, batch, work);
    glance.weight *= surface.transmission;
    sender_.send(glance, batch, work);
}

void Transparency::sendSpectrum(const Surface& surface, const LightPath& path,
                                const SecondaryRayRequest& white, SampleBatch& batch,
                                TileScratch& work) const {
    const Material& material = *materialOf(batch.points, surface.first);
    const int samples = scene_.interiors[static_cast<std::size_t>(material.interior)].dispersionSamples;
    for (int i = 0; i < samples; ++i) {
        LightPath colored = path;
        SecondaryRayRequest glance = white;
        glance.weight *= spectralColor(static_cast<double>(i) / samples, (i + 1.0) / samples);
        glance.dispersed = colored.dispersed = true;
        glance.spectralPlace = colored.spectralPlace = static_cast<float>((i + 0.5) / samples);
        sendBent(surface, colored, glance, batch, work);
    }
}

void Transparency::sendBent(const Surface& surface, const LightPath& path, SecondaryRayRequest glance,
                            SampleBatch& batch, TileScratch& work) const {
    const SurfacePoints& points = batch.points;
    const Material& material = *materialOf(points, surface.first);
    glance.sender = StageKind::refraction;
    glance.straight = false;
    if (bend(crossingAt(scene_, path, material), at(points.normal, surface.first), glance.ray.direction)) {
        glance.weight *= surface.transmission;
    } else {
        glance.ray.direction = mirrored(points, surface.first, material);
        glance.inside = path.inside;
        glance.reflected = true;
        if (batch.mirrored.empty()) batch.mirrored.resize(batch.size());
        batch.mirrored[glance.sample] = 1;
    }
    sender_.send(glance, batch, work);
}

namespace {

EffectReason reasonFor(const Scene& scene) {
    return reasonOfObjects(
        scene, [](const SceneObject& object) { return isSeen(object) && object.transparent; },
        "lets light through", "every object is opaque");
}

void build(PictureParts& parts) {
    parts.addStage(std::make_unique<Transparency>(parts.scene(), parts.plan.has(StageKind::refraction)));
    parts.sendsRays = true;
    parts.knowsInteriors = true;
}

EffectReason reasonForRefraction(const Scene& scene) {
    if (!reasonFor(scene).needed) return {false, "every object is opaque"};
    const auto bends = [](const SceneObject& object) {
        return isSeen(object) && object.transparent && object.bendsLight;
    };
    return reasonOfObjects(scene, bends, "has an ior", "no transparent object has an ior");
}

}  // namespace

// To look straight through takes as many rays as the stage itself: then it would not be left out. Who wants
// that leaves out refraction.
const EffectDescription effects::transparency{
    .name = "transparency",
    .reasonFor = reasonFor,
    .build = build,
    .leftOutNote = "; without it these objects are drawn as opaque, and nothing is refracted",
};

const EffectDescription effects::refraction{
    .name = "refraction",
    .reasonFor = reasonForRefraction,
    .leftOutNote = "; without it light goes straight through",
};

}  // namespace isoscope
