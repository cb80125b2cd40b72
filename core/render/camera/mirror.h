// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <glm/geometric.hpp>

#include "core/render/camera/crossing.h"
#include "core/render/light/reflectance.h"
#include "core/render/light/surface_light.h"

namespace isoscope {

/// The normal at point k, turned to where the ray comes from unless it was bent away from there on purpose.
inline glm::dvec3 facingNormal(const SurfacePoints& points, std::size_t k, const Material& material) {
    const glm::dvec3 normal = at(points.normal, k);
    const bool bent = points.lookedUp && material.normalTape;
    return !bent && glm::dot(normal, at(points.view, k)) > 0 ? -normal : normal;
}

/// The colour of the pigment at point k, not weakened by its transparency.
inline glm::dvec3 pigmentAt(const Material& material, const SurfacePoints& points, std::size_t k) {
    if (points.lookedUp && (points.weighted || material.pigmentTape)) return at(points.tint, k);
    const auto* solid = std::get_if<SolidPigment>(&material.pigment);
    return solid ? rgb(solid->color) : glm::dvec3(0);
}

/// The direction from which a mirror at point k shows light. Where a bent normal would have it come through
/// the surface it is mirrored there once more, or, where the normal is bent away from the viewer, there
/// alone, as in POV-Ray (seen in its pictures).
inline glm::dvec3 mirrored(const SurfacePoints& points, std::size_t k, const Material& material) {
    const auto mirror = [](const glm::dvec3& way, const glm::dvec3& normal) {
        return way - 2 * glm::dot(way, normal) * normal;
    };
    const glm::dvec3 view = at(points.view, k), normal = at(points.normal, k);
    glm::dvec3 direction = mirror(view, normal);
    if (points.lookedUp && material.normalTape) {
        const glm::dvec3 straight = at(points.straight, k);
        if (glm::dot(direction, straight) < 0)
            direction = mirror(glm::dot(view, normal) > 0 ? view : direction, straight);
    }
    return glm::normalize(direction);
}

/// What the finish of the material mirrors at point k to a ray of this path.
inline glm::dvec3 reflectanceAt(const Scene& scene, const Material& material, const SurfacePoints& points,
                                std::size_t k, const LightPath& path) {
    const Finish& finish = material.finish;
    const double ratio = finish.reflectionFresnel ? crossingAt(scene, path, material).ratio() : 1;
    const double cosine = -glm::dot(at(points.view, k), facingNormal(points, k, material));
    const glm::dvec3 pigment =
        finish.reflectionMetallic != 0 ? pigmentAt(material, points, k) : glm::dvec3(0);
    return reflectance(finish, pigment, cosine, ratio);
}

}  // namespace isoscope
