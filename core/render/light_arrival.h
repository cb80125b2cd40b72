// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

#include "core/scene/color.h"
#include "core/scene/light_source.h"

namespace isoscope {

/// The light of one source at one point.
struct LightArrival {
    glm::dvec3 direction{0};  ///< from the point to the source, unit length
    double distance = 0;      ///< to the source (parallel light: to its plane)
    glm::dvec3 color{0};      ///< after cone, tightness and distance; 0 where nothing arrives
    bool highlights = true;   ///< false for shadowless lights: POV-Ray shows no phong or specular of them
};

/// How POV-Ray 3.7 spreads the light of a source, shadows aside: spotlight and cylinder fall off between
/// `radius` and `falloff`, all weaken with distance when fadeDistance or fadePower say so. Checked against
/// POV-Ray's pictures.
LightArrival lightArrival(const LightSource& light, const glm::dvec3& point);

inline glm::dvec3 rgb(const Color& color) { return {color.red, color.green, color.blue}; }

}  // namespace isoscope
