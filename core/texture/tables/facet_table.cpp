// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/tables/facet_table.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/numeric/crackle.h"

namespace isoscope {

namespace {

/// Of those that crackle looks at.
std::array<double, 3> leastPoint(const std::array<double, 3>& point) {
    constexpr double onBorder = 1e-10;
    std::array<std::int64_t, 3> cell{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        cell[axis] = static_cast<std::int64_t>(std::floor(point[axis] - onBorder));
    std::array<double, 3> least{};
    double leastSum = std::numeric_limits<double>::infinity();
    for (int i = -2; i <= 2; ++i)
        for (int j = -2; j <= 2; ++j)
            for (int k = -2; k <= 2; ++k) {
                if (i * i / 4 + j * j / 4 + k * k / 4 > 1) continue;
                const std::array<double, 3> candidate = cracklePoint(cell[0] + i, cell[1] + j, cell[2] + k);
                double sum = 0;
                for (std::size_t axis = 0; axis < 3; ++axis) sum += candidate[axis] - point[axis];
                if (sum < leastSum) {
                    leastSum = sum;
                    least = candidate;
                }
            }
    return least;
}

}  // namespace

double FacetTable::value(const std::array<double, 3>& point) const {
    const CrackleDistances nearest = crackleDistances(point[0], point[1], point[2], metric_, 0);
    if (std::isnan(nearest.d[0])) return 0;
    const std::array<double, 3> taken = metric_ == 1 ? leastPoint(point) : nearest.points[0];
    return std::clamp(taken[axis_] - std::floor(point[axis_]), low(), high());
}

}  // namespace isoscope
