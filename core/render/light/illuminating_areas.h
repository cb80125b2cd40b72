// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/scene/light_source.h"

namespace isoscope {

/// The lights of the grid of a light that shines from its whole area (`area_illumination`), each with its
/// share of the colour; none for all others. Grids that turn to what they light, and those of more than 1024
/// lights, shine from their middle: their shadows alone are soft.
std::vector<LightSource> illuminatingLights(const LightSource& light);

}  // namespace isoscope
