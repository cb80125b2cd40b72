// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/evaluate/tape/tape_workspace.h"

namespace isoscope {

/// Runs instructions of the tape of a workspace of three components (high, -low, doubt) on intervals, for at
/// least the first `lanes` lanes (1 to batchLanes, rounded up to whole vectors), with the best instruction
/// set of the machine. The rounding mode is upwards meanwhile and to nearest afterwards.
void runIntervalInstructions(TapeWorkspace& workspace, std::span<const Instruction> instructions,
                             std::size_t lanes);

}  // namespace isoscope
