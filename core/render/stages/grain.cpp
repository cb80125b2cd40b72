// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/stages/grain.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/render/camera/place_random.h"
#include "core/render/light/surface_light.h"

namespace isoscope {

namespace {

glm::dvec3 pigmentAt(const Material& material, const SurfacePoints& points, std::size_t k) {
    if (material.pigmentTape || points.weighted) return at(points.pigment, k);
    const auto* solid = std::get_if<SolidPigment>(&material.pigment);
    return solid ? rgb(solid->color) : glm::dvec3(0);
}

/// What the surface returns of a white light by `diffuse` alone (findReturned).
double diffusePart(const Material& material, const SurfacePoints& points, std::size_t k) {
    const glm::dvec3 normal = at(points.normal, k);
    const bool turned = !material.normalTape && glm::dot(normal, at(points.view, k)) > 0;
    const double cosine = glm::dot(normal, at(points.toLight, k)) * (turned ? -1 : 1);
    return cosine > 0 ? material.finish.diffuse * std::pow(cosine, material.finish.brilliance) : 0;
}

}  // namespace

void Grain::filter(TileScratch& work, SurfacePoints& points, std::size_t light) const {
    const glm::dvec3 color = rgb(scene_.lights[light].color);
    work.charge(StageKind::directLight);
    for (std::size_t k = 0; k < points.size(); ++k) {
        const auto id = static_cast<std::size_t>(points.materials[k]);
        if (points.materials[k] < 0 || id >= scene_.materials.size()) continue;
        const Material& material = scene_.materials[id];
        if (!(material.finish.crand > 0)) continue;
        const double loss = std::min(material.finish.crand * PlaceRandom(at(points.point, k), light).next(),
                                     diffusePart(material, points, k));
        const glm::dvec3 lost = loss * points.strength[k] * color * pigmentAt(material, points, k);
        for (int c = 0; c < 3; ++c) {
            double& returned = points.returned[static_cast<std::size_t>(c)][k];
            returned = std::max(0.0, returned - lost[c]);
        }
    }
    work.charge(StageKind::grain);
}

}  // namespace isoscope
