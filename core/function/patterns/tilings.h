// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/function/patterns/plane_point.h"

namespace isoscope {

/// One convex tile, anticlockwise as seen with x to the right and z upwards.
struct Tile {
    int kind = 0;  ///< 0 to Tiling::kinds - 1
    std::vector<PlanePoint> corners;
    /// How far the bevel reaches in from each side, from corner k to the next; empty: Tiling::bevel.
    std::vector<double> bevels;
};

/// A tiling of the plane by a few tiles that are repeated along two vectors. It was found by measuring
/// POV-Ray 3.7: where a tile of kind k ends the pattern is (k + 1) / kinds, and from there it falls straight
/// to k / kinds over the width of the bevel.
struct Tiling {
    int kinds = 1;
    double bevel = 0.5;
    PlanePoint across{1, 0}, along{0, 1};
    std::vector<Tile> tiles;
};

/// Of `tiling N`, those that repeat.
constexpr int tilingCount = 24;
/// Those that do not: KiteTiling and PenroseTiling.
constexpr int pentagonTiling = 25, kiteTiling = 26, rhombTiling = 27;

/// Tiling number 1 to tilingCount, built on first use; other numbers act as the nearer end.
const Tiling& tilingOf(int number);

/// The copies of the tiles that reach into the parallelogram of the two vectors from the origin.
std::vector<Tile> tilesInCell(const Tiling& tiling);

}  // namespace isoscope
