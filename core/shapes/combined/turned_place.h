// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <glm/vec3.hpp>
#include <numbers>

namespace isoscope {

/// How far a point is around the y axis, 0 to 1 from x by z: the u of `uv_mapping` for round shapes.
inline double turnedPlace(double x, double z) {
    const double turn = std::atan2(z, x) / (2 * std::numbers::pi);
    return turn < 0 ? turn + 1 : turn;
}

}  // namespace isoscope
