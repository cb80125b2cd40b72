// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/function/point_table.h"

#include <algorithm>
#include <cmath>

#include "core/numeric/interval.h"

namespace isoscope {

Interval PointTable::range(const std::array<Interval, 3>& box) const {
    const bool usual = std::all_of(box.begin(), box.end(), [](const Interval& side) {
        return side.isDefined() && std::isfinite(side.low) && std::isfinite(side.high);
    });
    return usual ? rangeIn(box) : Interval{low(), high(), false};
}

Interval PointTable::rangeIn(const std::array<Interval, 3>&) const { return {low(), high(), false}; }

}  // namespace isoscope
