// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "core/render/light/surface_light.h"
#include "core/scene/scene.h"

namespace isoscope {

/// What a colour lets through of the light behind it.
inline glm::dvec3 transmission(const Color& color) {
    return rgb(color) * color.filter + glm::dvec3(color.transmit);
}

/// What a colour shows of itself where it lets light through. Below 0 where it lets through more than all, as
/// in POV-Ray 3.7, on whose pictures both rules were measured.
inline double opacity(const Color& color, OpacityRule rule) {
    if (rule == OpacityRule::sum) return 1 - color.filter - color.transmit;
    const glm::dvec3 through = transmission(color);
    return 1 - std::max({through.x, through.y, through.z});
}

/// The version in force at the end of the text decides for all of it.
inline OpacityRule opacityRule(const Scene& scene) {
    return scene.languageVersion < 370 ? OpacityRule::strongest : OpacityRule::sum;
}

/// What the surface lets through at point k: of patterns and layers as the textures have found it.
inline glm::dvec3 transmissionAt(const Material& material, const SurfacePoints& points, std::size_t k) {
    if (points.weighted) return at(points.transmission, k);
    if (!material.transparent) return glm::dvec3(0);
    if (material.pigmentTape) return points.lookedUp ? at(points.transmission, k) : glm::dvec3(0);
    const auto* solid = std::get_if<SolidPigment>(&material.pigment);
    return solid && material.parts.empty() ? transmission(solid->color) : glm::dvec3(0);
}

/// What is left of light after this distance through an interior that fades (POV-Ray 3.7, measured).
inline glm::dvec3 fading(const Interior& interior, double distance) {
    if (!interior.fades()) return glm::dvec3(1);
    const double way = distance / interior.fadeDistance;
    const glm::dvec3 color = rgb(interior.fadeColor), lost = glm::dvec3(1) - color;
    // From here on the power stands for the law of Lambert and Beer.
    if (interior.fadePower >= 1000)
        return {std::exp(-lost.x * way), std::exp(-lost.y * way), std::exp(-lost.z * way)};
    return color + lost / (1 + std::pow(way, interior.fadePower));
}

}  // namespace isoscope
