// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

#include "core/render/light/surface_points.h"
#include "core/scene/light_source.h"
#include "core/scene/material.h"

namespace isoscope {

/// The three channels of light, without filter and transmit.
inline glm::dvec3 rgb(const Color& color) { return {color.red, color.green, color.blue}; }

/// How much of its own a pigment shows that lets light through.
enum class OpacityRule {
    sum,        ///< 1 - filter - transmit: from `#version 3.7` on
    strongest,  ///< 1 - what it lets through of the channel that comes through best: before
};

/// Points [first, end) of one material.
struct PointRange {
    std::size_t first = 0, end = 0;
};

/// Sets `shine` of the points to what they shine without any light source: ambient and emission. Entries
/// behind the range, up to the length of a vector, get unspecified numbers.
void findSelfLight(const Material& material, OpacityRule rule, const glm::dvec3& ambientLight,
                   const PointRange& range, SurfacePoints& points);

/// Sets `returned` of the points to what they return to the viewer of the light that arrives (findArrival):
/// diffuse with brilliance, phong, specular, metallic, after POV-Ray 3.7 (formulas measured on its pictures).
/// Shadowless lights make no highlights, as in POV-Ray. Entries behind the range, up to the length of a
/// vector, get unspecified numbers. `wavelengths` are those of red, green and blue for thin films
/// (GlobalSettings::iridWavelength).
void findReturned(const LightSource& light, const Material& material, OpacityRule rule,
                  const glm::dvec3& wavelengths, const PointRange& range, SurfacePoints& points);

/// Adds `returned` to `shine`.
void addReturned(SurfacePoints& points);

}  // namespace isoscope
