// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/function/patterns/pattern.h"
#include "core/function/patterns/tilings.h"
#include "core/function/point_table.h"

namespace isoscope {

struct PavementLayout;

/// `pavement`: the xz plane paved with tiles that are a few triangles, squares or hexagons with unit sides
/// put together. Measured on POV-Ray 3.7: 1 where tiles meet, and from there it falls straight to 0 over the
/// width of the bevel, the radius of the circle in a triangle or a square (of a triangle for hexagons). Where
/// a tile has a corner that points inwards the greater distance from the lines of its sides counts; at those
/// of 60 degrees the distance from a line across the tip, too. 0 for coordinates beyond 1e9.
class Pavement : public PointTable {
  public:
    /// The layout that is nearest to the choice.
    static std::shared_ptr<const Pavement> of(const PavementChoice& choice);

    double value(const std::array<double, 3>& point) const override;

  private:
    explicit Pavement(const PavementLayout& layout) : layout_(layout) {}

    struct Corner;
    /// Whether tiles meet at a side of a cell, as PavementLayout counts them.
    bool isBorder(long long i, long long j, int side) const;
    /// How far a point near a corner lies inside of a tile.
    double depthAt(const Corner& corner, PlanePoint point) const;

    const PavementLayout& layout_;
};

/// The choice itself where there is such a pavement: of cells with 3, 4 or 6 sides, up to 6 (with 6 sides 5)
/// in a tile, each in 1 to 35 ways.
PavementChoice nearestPavement(const PavementChoice& choice);

}  // namespace isoscope
