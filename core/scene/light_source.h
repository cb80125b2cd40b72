// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

#include "core/scene/color.h"

namespace isoscope {

enum class LightKind { point, spotlight, cylinder, parallel };

/// A light of the scene; angles in degrees, as POV-Ray's light_source.
struct LightSource {
    LightKind kind = LightKind::point;
    glm::dvec3 location{0};
    Color color{1, 1, 1};
    glm::dvec3 pointAt{0, 0, 0};
    double radius = 30;
    double falloff = 45;
    double tightness = 0;
    double fadeDistance = 0;
    double fadePower = 0;
    bool shadowless = false;
    int line = 0;  ///< of the statement, for the plan's reasons
};

}  // namespace isoscope
