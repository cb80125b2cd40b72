// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/numeric/crackle.h"

namespace isoscope::test {

/// All 81 cells without any shortcut, the nearest first.
inline CrackleDistances slowDistances(double x, double y, double z, double metric = 2, double offset = 0) {
    const double cell[3] = {std::floor(x - 1e-10), std::floor(y - 1e-10), std::floor(z - 1e-10)};
    std::vector<std::pair<double, std::array<double, 3>>> all;
    for (int i = -2; i <= 2; ++i)
        for (int j = -2; j <= 2; ++j)
            for (int k = -2; k <= 2; ++k) {
                if ((std::abs(i) == 2) + (std::abs(j) == 2) + (std::abs(k) == 2) > 1) continue;
                const auto point = cracklePoint(std::int64_t(cell[0]) + i, std::int64_t(cell[1]) + j,
                                                std::int64_t(cell[2]) + k);
                const double dx = x - point[0], dy = y - point[1], dz = z - point[2];
                all.emplace_back(
                    metric == 2 ? std::sqrt(dx * dx + dy * dy + dz * dz)
                                : std::pow(std::pow(std::abs(dx), metric) + std::pow(std::abs(dy), metric) +
                                               std::pow(std::abs(dz), metric),
                                           1 / metric),
                    point);
            }
    std::sort(all.begin(), all.end());
    CrackleDistances nearest;
    for (std::size_t rank = 0; rank < 3; ++rank) {
        const double d = all[rank].first;
        nearest.d[rank] =
            offset == 0 ? d : std::pow(std::pow(d, metric) + std::pow(offset, metric), 1 / metric);
        nearest.points[rank] = all[rank].second;
    }
    return nearest;
}

}  // namespace isoscope::test
