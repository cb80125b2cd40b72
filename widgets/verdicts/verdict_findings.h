// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "core/language/parse.h"
#include "core/study/gradient/surface_verdict.h"

namespace isoscope {

/// What Problems lists of the verdicts: nothing for those that are right or still being proven. `parsed` has
/// the places; the verdicts are about its isosurfaces. Isosurfaces whose max_gradient can be mended come with
/// the change ("Use 2.06"); those that one statement makes, in a loop or macro, get the largest that any of
/// them needs.
Diagnostics verdictFindings(const std::vector<SurfaceVerdict>& verdicts, const ParseResult& parsed);

/// What max_gradient should be for those isosurfaces, by their numbers, for which the present one is too low,
/// too high or not proven, and a better one is.
std::map<std::size_t, double> neededGradients(const std::vector<SurfaceVerdict>& verdicts,
                                              const ParseResult& parsed);

/// Line of the max_gradient of each isosurface, or of its statement where the text has none, from 1; 0 for
/// those outside the user's own text.
std::vector<int> verdictLines(const ParseResult& parsed);

}  // namespace isoscope
