// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "core/function/function_graph.h"

namespace isoscope {

/// More than what the roundings of a few operations amount to, as a part of the largest number among them.
constexpr double crackleRoundings = 1e-14;

/// From here on coordinates have no cell, give or take.
constexpr double lastCrackleCell = 4e18;

/// How many of the nearest distances count, 1 to 3.
inline int orderOfCrackle(const CrackleSettings& settings) {
    if (settings.solid) return 1;
    return settings.form[2] != 0 ? 3 : settings.form[1] != 0 ? 2 : 1;
}

/// Affine forms a + b s + [-e, e], one for each lane.
struct FormColumn {
    const double *a, *b, *e;
};

/// Encloses crackle of the Euclidean metric at pieces of rays, before values are cut to 0..1: `lanes` forms
/// of x, y and z, of which there are whole vectors (8 lanes at most) to read, and to write to `result` (a's,
/// b's and e's). From 0 to 1 where the nearest points are not known; e is infinite where there are no cells.
/// What a lane gets depends on no other one.
void writeEuclideanCrackle(const std::array<FormColumn, 3>& place, const CrackleSettings& settings,
                           std::size_t lanes, const std::array<double*, 3>& result);

}  // namespace isoscope
