// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <numbers>

namespace isoscope {

/// A point, or a way, in the plane of a tiling: x and z of the pattern's coordinates.
using PlanePoint = std::array<double, 2>;

/// A way of a length in a direction, anticlockwise from +x as seen with z upwards.
inline PlanePoint polar(double length, double degrees) {
    const double angle = degrees * (std::numbers::pi / 180);
    return {length * std::cos(angle), length * std::sin(angle)};
}

/// Twice the area of the triangle that two ways span; above 0 if b leads to the left of a.
inline double cross(PlanePoint a, PlanePoint b) { return a[0] * b[1] - a[1] * b[0]; }

/// One way after the other.
inline PlanePoint sum(PlanePoint a, PlanePoint b) { return {a[0] + b[0], a[1] + b[1]}; }
/// The way from b to a.
inline PlanePoint difference(PlanePoint a, PlanePoint b) { return {a[0] - b[0], a[1] - b[1]}; }

}  // namespace isoscope
