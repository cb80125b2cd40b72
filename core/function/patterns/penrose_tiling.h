// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/function/point_table.h"

namespace isoscope {

/// Penrose's tiling of rhombs with unit sides in the xz plane, number 27 of `tiling`, with its fivefold
/// centre at the origin. As Tiling, with two kinds: 0 are the rhombs with an angle of 72 degrees, 1 those
/// with 36. 0 for coordinates beyond 1e9.
///
/// Made by N. G. de Bruijn's pentagrid ("Algebraic theory of Penrose's non-periodic tilings of the plane",
/// 1981): where lines of two of five families cross there is a rhomb. POV-Ray's values are those of families
/// that are shifted by 4/5 each (measured).
class PenroseTiling : public PointTable {
  public:
    double value(const std::array<double, 3>& point) const override;
};

}  // namespace isoscope
