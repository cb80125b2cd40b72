// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

namespace isoscope {

/// Where tiles of a pavement meet, in cells (i, j) that repeat: (i + width, j) and (i + shift, j + rows) are
/// as (i, j). `borders` has an octal digit for each, i running first from 0, of which a bit says that tiles
/// meet at one of its sides:
///
/// Squares from (i, j) to (i + 1, j + 1): the right side (1), the upper one (2).
/// Triangles that point upwards, from i (1, 0) + j (1/2, h), h = sqrt(3)/2: the lower side (1), the left (2),
/// the right one (4).
/// Hexagons around (-1/2, h) + i (3/2, h) + j (0, 2 h): the upper side (1), the upper right (2), the lower
/// right one (4).
struct PavementLayout {
    int sides;  ///< of a cell
    int tiles;  ///< cells of a tile
    int width, rows, shift;
    std::string_view borders;
};

/// All of POV-Ray 3.7 (measured), in the order of their sides, tiles and numbers.
std::span<const PavementLayout> pavementLayouts();

}  // namespace isoscope
