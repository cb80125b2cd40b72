// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/function/point_table.h"

namespace isoscope {

/// How far the cell point of crackle that `facets` takes for a point lies from the corner of the unit cube
/// around it, along one axis (docs/povray/patterns.md, 2.2): the nearest one, but in metric 1 the one with
/// the least sum of its coordinates, as POV-Ray's pictures show. 0 where crackle has no value.
class FacetTable : public PointTable {
  public:
    FacetTable(std::size_t axis, double metric) : axis_(axis), metric_(metric) {}

    double value(const std::array<double, 3>& point) const override;
    // Crackle looks at cells up to two away, and at one more beside the upper sides of a cell.
    double low() const override { return -3; }
    double high() const override { return 3; }

  private:
    std::size_t axis_;
    double metric_;
};

}  // namespace isoscope
