// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/numeric/crackle_candidates.h"

namespace isoscope {

/// Whether all points of these cells look at every cell point that is among their nearest `order` (1 to 3),
/// so that crackle does not jump among them. False when that is not known: in metrics below 1, and of more
/// than `mostCrackleCells` cells. What was found out about a cell is kept for each thread.
bool crackleSeesEnough(const CrackleCells& cells, double metric, int order);

constexpr std::int64_t mostCrackleCells = 4096;

}  // namespace isoscope
