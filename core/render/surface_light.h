// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

#include "core/render/light_arrival.h"
#include "core/scene/material.h"

namespace isoscope {

/// What the surface shines without any light source: ambient and emission.
glm::dvec3 selfLight(const Material& material, const glm::dvec3& ambientLight);

/// What a surface returns to the viewer of the light that arrives: diffuse with brilliance, phong, specular,
/// metallic, after POV-Ray 3.7 (formulas measured on its pictures). `normal` has unit length and either
/// sense, `view` is the direction of the ray that met the surface.
glm::dvec3 returnedLight(const Material& material, const glm::dvec3& normal, const glm::dvec3& view,
                         const LightArrival& arrival);

}  // namespace isoscope
