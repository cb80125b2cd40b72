// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "core/texture/image_map.h"

namespace isoscope {

/// Where a point of an image's own coordinates lies on it: u and v from the left and from below, 1 for its
/// whole width and height, over and over. For numbers, and for expressions of a graph. Images that are not
/// planar are wrapped about the y axis, and u is between -1/2 and 1/2.
template <class Number>
std::array<Number, 2> imagePlace(ImageMapType type, const Number& x, const Number& y, const Number& z) {
    using std::atan2, std::sqrt, std::numbers::pi;
    if (type == ImageMapType::planar) return {x, y};
    const Number turns = atan2(z, x) / (2 * pi), around = sqrt(x * x + z * z);
    if (type == ImageMapType::cylindrical) return {turns, y};
    if (type == ImageMapType::torus) return {turns, 0.5 + atan2(y, around - 1) / (2 * pi)};
    return {turns, 0.5 + atan2(y, around) / pi};
}

}  // namespace isoscope
