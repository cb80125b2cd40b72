// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

#include "core/render/light/surface_light.h"
#include "core/scene/material.h"

namespace isoscope {

/// A material and a light, in numbers.
struct Lighting {
    glm::dvec3 pigment{0};
    glm::dvec3 tint{0};  ///< the pigment as it is where nothing comes through: the colour of metals
    glm::dvec3 light{0};
    Finish finish;
    bool highlights = true;
    bool patterned = false;     ///< pigment and tint are those of SurfacePoints instead
    bool doubled = false;       ///< light from behind counts as well
    glm::dvec3 wavelengths{0};  ///< of red, green and blue, for thin films
    bool unevenFilm = false;    ///< the film is as thick as SurfacePoints says
    bool bent = false;          ///< the normals face the viewer, or were bent away on purpose
};

/// `wavelengths` are those for thin films.
Lighting lightingOf(const LightSource& light, const Material& material, OpacityRule rule,
                    const glm::dvec3& wavelengths);

/// What a material of a single colour shines without any light source.
glm::dvec3 selfLight(const Material& material, OpacityRule rule, const glm::dvec3& ambientLight);

}  // namespace isoscope
