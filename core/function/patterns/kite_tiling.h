// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/function/patterns/tilings.h"
#include "core/function/point_table.h"

namespace isoscope {

/// A polygon of a tiling, anticlockwise, in which corners may point inwards, but not the first.
struct PenroseShape {
    int kind = 0;
    std::vector<PlanePoint> corners;

    /// How deep a point lies inside, below 0 outside: the least distance from the lines of the sides, where
    /// of two that meet in a corner that points inwards the greater one counts.
    double depth(PlanePoint point) const;
};

/// Penrose's tilings of pentagons, stars, boats and diamonds with unit sides (number 25 of `tiling`), and of
/// kites and darts with long sides of 1 (26), in the xz plane with a fivefold centre at the origin. Values
/// are as those of Tiling, the widths of their bevels measured. 0 for coordinates beyond 1e9.
///
/// A point is looked for in halves of kites and darts that are divided by the golden ratio again and again
/// (M. Gardner, "Extraordinary nonperiodic tiling that enriches the theory of tiles", 1977). Pentagons of
/// the one are found in the kites and darts of a coarser one, always at the same places (measured).
class KiteTiling : public PointTable {
  public:
    /// Number 25 or 26.
    enum class Tiles { pentagons, kites };
    explicit KiteTiling(Tiles tiles);

    double value(const std::array<double, 3>& point) const override;

  private:
    struct HalfTile;
    HalfTile halfTileAt(PlanePoint point) const;

    int kinds_;
    double steepness_;  ///< 1 / the width of the bevel
    /// Long sides of kites are `unit_` times a power of the golden ratio: of power `finest_` for those whose
    /// shapes are known, of `turn_` and 4 more each where five kites around the origin point to +x.
    double unit_;
    int finest_, turn_;
    /// What is seen in half of a kite, or of a dart, whose tip is the origin: its axis is +x, its wing has a
    /// z above 0. Shapes are whole.
    std::vector<PenroseShape> inKite_, inDart_;
};

}  // namespace isoscope
