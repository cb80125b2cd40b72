// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

namespace isoscope {

/// The point of an integer cell of the crackle pattern (spec/patterns.md, 2.2).
std::array<double, 3> cracklePoint(std::int64_t i, std::int64_t j, std::int64_t k);

/// The nearest cell point and the three smallest distances, d[0] <= d[1] <= d[2], from (x, y, z) in the
/// metric |dx|^m + ... (spec/patterns.md, section 3). Non-finite coordinates give NaN distances.
struct CrackleDistances {
    std::array<double, 3> d;
    std::array<double, 3> nearest;
};
CrackleDistances crackleDistances(double x, double y, double z, double metric, double offset);

}  // namespace isoscope
