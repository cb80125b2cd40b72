// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

#include "core/scene/material.h"

namespace isoscope {

/// POV-Ray's `rainbow`: an arc of colours in the haze, seen where the direction of sight and `direction`
/// enclose about `angle`. Angles in degrees.
struct Rainbow {
    glm::dvec3 direction{0, 0, 1};  ///< of the light that makes it
    glm::dvec3 up{0, 1, 0};
    double angle = 0;
    double width = 0;
    double distance = 0;  ///< nearer than this it fades
    double jitter = 0;
    double arcAngle = 180;
    double falloffAngle = 180;
    /// The colours from the inside out, by a pigment that is looked up at <0..1, 0, 0>.
    Material colors;
    int line = 0;  ///< of the statement, for the plan's reasons
};

}  // namespace isoscope
