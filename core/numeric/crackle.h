// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

namespace isoscope {

/// The uniform sequence U of docs/povray/patterns.md, 2.1: the first `uniformCount` words of MT19937 with its
/// standard seed, each divided by 2^32. Crackle needs no more of it.
constexpr int uniformCount = 4098;
const std::array<double, uniformCount>& uniformSequence();

/// The point of an integer cell of the crackle pattern (docs/povray/patterns.md, 2.2).
std::array<double, 3> cracklePoint(std::int64_t i, std::int64_t j, std::int64_t k);

/// The value of the `cells` pattern: the first random number of the unit cell around a point, in [0, 1). NaN
/// where crackleDistances gives NaN.
double cellValue(double x, double y, double z);

/// The three smallest distances, d[0] <= d[1] <= d[2], with their cell points, from (x, y, z) in the
/// metric (|dx|^m + |dy|^m + |dz|^m)^(1/m), and with an offset o other than 0 in (d^m + o^m)^(1/m)
/// (docs/povray/patterns.md, section 3). Coordinates that are not finite or reach 2^62 in magnitude give NaN
/// distances.
struct CrackleDistances {
    std::array<double, 3> d;
    std::array<std::array<double, 3>, 3> points;
};
/// Costs least for `metric` 2, which has a search of its own. Pure and thread safe.
CrackleDistances crackleDistances(double x, double y, double z, double metric, double offset);

}  // namespace isoscope
