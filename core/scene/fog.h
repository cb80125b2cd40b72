// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

#include "core/scene/color.h"

namespace isoscope {

/// POV-Ray's `fog`: a haze everywhere, or (ground fog) one that thins out with height.
struct Fog {
    bool ground = false;
    double distance = 0;  ///< where 1/e of the light is left; 0: there is no fog
    /// `transmit` is the share that always comes through, `filter` how far it takes on the colour.
    Color color{};
    glm::dvec3 up{0, 1, 0};
    double offset = 0;    ///< below this height ground fog is constant
    double altitude = 0;  ///< so far above, a quarter of it is left
    glm::dvec3 turbulence{0};
    double turbulenceDepth = 0.5;
    int octaves = 6;
    double omega = 0.5;
    double lambda = 2;
    int line = 0;  ///< of the statement, for the plan's reasons
};

}  // namespace isoscope
