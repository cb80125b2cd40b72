// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/stages/transparency.h"

#include <cmath>

#include "core/render/mirror.h"
#include "core/render/transmission.h"

namespace isoscope {

Transparency::Transparency(const Scene& scene, bool refraction)
    : scene_(scene), sender_(scene.settings), refraction_(refraction) {}

void Transparency::run(TileWork& work, SampleBatch& batch) const {
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
    const InteriorList& inside = batch.path(points.samples[k]).inside;
    return all * (glm::dvec3(1) - reflectanceAt(scene_, *material, points, k, inside));
}

void Transparency::send(const Surface& surface, SampleBatch& batch, TileWork& work) const {
    if (surface.transmission == glm::dvec3(0)) return;
    const SurfacePoints& points = batch.points;
    const Material& material = *materialOf(points, surface.first);
    const LightPath& path = batch.path(points.samples[surface.first]);
    const Crossing crossing = crossingAt(scene_, path.inside, material);
    Glance glance;
    glance.sample = points.samples[surface.first];
    glm::dvec3 faded(1);
    if (crossing.leaves) {
        const Interior& left = scene_.interiors[static_cast<std::size_t>(material.interior)];
        if (left.fades())
            faded = fading(left, glm::distance(batch.origin(glance.sample), at(points.point, surface.first)));
    }
    glance.weight = faded * surface.transmission;
    glance.ray = {at(points.point, surface.first), at(points.view, surface.first)};
    glance.sender = StageKind::transparency;
    glance.inside = crossing.beyond;
    glance.straight = true;
    if (refraction_ && crossing.before != crossing.after &&
        !refract(crossing, facingNormal(points, surface.first, material), glance)) {
        glance.ray.direction = mirrored(points, surface.first);
        glance.weight = faded;
        glance.inside = path.inside;
        glance.reflected = true;
        if (batch.mirrored.empty()) batch.mirrored.resize(batch.size());
        batch.mirrored[glance.sample] = 1;
    }
    sender_.send(glance, batch, work);
}

/// Snell's law.
bool Transparency::refract(const Crossing& crossing, const glm::dvec3& normal, Glance& glance) const {
    glance.sender = StageKind::refraction;
    glance.straight = false;
    const double ratio = crossing.before / crossing.after;
    const double cosine = -glm::dot(glance.ray.direction, normal);
    const double square = 1 - ratio * ratio * (1 - cosine * cosine);
    if (!(square >= 0)) return false;
    const glm::dvec3 bent = ratio * glance.ray.direction + (ratio * cosine - std::sqrt(square)) * normal;
    const double length = glm::length(bent);
    if (length > 0 && std::isfinite(length)) glance.ray.direction = bent / length;
    return true;
}

}  // namespace isoscope
