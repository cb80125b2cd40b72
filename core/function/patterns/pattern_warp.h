// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <variant>

#include "core/function/graph_builder.h"

namespace isoscope {

using PatternPoint = std::array<Expression, 3>;

/// `translate`, `rotate`, `scale`, `matrix`: four rows of three numbers that take a point to where the
/// pattern is looked up, p' = x*row0 + y*row1 + z*row2 + row3 (the inverse of the transformation as written).
struct TransformWarp {
    std::array<double, 12> inverse{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
};

/// `warp { turbulence amount octaves lambda omega }`.
struct TurbulenceWarp {
    std::array<double, 3> amount{1, 1, 1};
    int octaves = 6;
    double lambda = 2;
    double omega = 0.5;
};

/// `warp { repeat axis*width offset V flip V }`: the slab [0, width) along an axis, over and over; slab
/// number n is moved by n times the offset, and odd ones are mirrored along the axes of a non-zero flip.
struct RepeatWarp {
    int axis = 0;
    double width = 1;  ///< not 0
    std::array<double, 3> offset{0, 0, 0};
    std::array<bool, 3> flip{false, false, false};
};

/// `warp { black_hole center, radius strength S falloff F inverse repeat V turbulence T }`. Along the axes of
/// a V greater than 0 the hole is there in every block of space of that width, moved within it by T times a
/// random vector.
struct BlackHoleWarp {
    std::array<double, 3> center{0, 0, 0};
    double radius = 1;
    double strength = 1;
    double falloff = 2;
    bool inverse = false;
    std::array<double, 3> repeat{0, 0, 0};
    std::array<double, 3> turbulence{0, 0, 0};  ///< counts where anything repeats
};

/// `warp { planar orientation, distance }`.
struct PlanarWarp {
    std::array<double, 3> orientation{0, 0, 1};  ///< of unit length
    double distance = 0;
};

/// `warp { spherical | cylindrical | toroidal orientation V dist_exp E major_radius R }`.
struct RoundWarp {
    /// The surface around the y axis whose longitude, latitude (of a cylinder the height) and distance become
    /// the coordinates of the pattern.
    enum class Kind { spherical, cylindrical, toroidal };

    Kind kind = Kind::spherical;
    std::array<double, 3> orientation{0, 0, 1};  ///< of unit length
    double distanceExponent = 0;
    double majorRadius = 1;  ///< of toroidal
};

using PatternWarp =
    std::variant<TransformWarp, TurbulenceWarp, RepeatWarp, BlackHoleWarp, PlanarWarp, RoundWarp>;

/// Where the pattern is looked up for a point.
PatternPoint warpedPoint(const PatternWarp& warp, const PatternPoint& point);

/// One component (axis 0, 1, 2) of the vector turbulence DTurb (docs/povray/noise.md, section 7). Octaves are
/// held in 1..10, lambda and omega rounded to single precision.
Expression vectorTurbulence(const PatternPoint& point, std::size_t axis, int octaves, double lambda,
                            double omega);

}  // namespace isoscope
