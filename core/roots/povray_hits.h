// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace isoscope {

/// Where POV-Ray's halving of [near, far] ends that finds a change of sign at `root` (docs/povray/solver.md):
/// up to the accuracy (`tolerance`, by t) behind it. There the normal is taken, which at a jump makes all the
/// difference. `root` where doubles cannot be halved any more. Of `count` lines; the columns go on as those
/// of LineColumns. `far` receives the places, `near` is used up.
void endPovrayHalvings(std::size_t count, double tolerance, const double* root, double* near, double* far);

}  // namespace isoscope
