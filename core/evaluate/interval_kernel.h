// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/evaluate/tape/tape_workspace.h"

namespace isoscope {

/// Rounds upwards during its life, and to nearest afterwards.
class UpwardRounding {
  public:
    UpwardRounding();
    ~UpwardRounding();
    UpwardRounding(const UpwardRounding&) = delete;
    UpwardRounding& operator=(const UpwardRounding&) = delete;
};

/// Runs instructions of the tape of a workspace of three components (high, -low, doubt) on intervals, for at
/// least the first `lanes` lanes (1 to batchLanes, rounded up to whole vectors), with the best instruction
/// set of the machine. The rounding mode must be upwards (UpwardRounding).
void runIntervalInstructions(TapeWorkspace& workspace, std::span<const Instruction> instructions,
                             std::size_t lanes);

}  // namespace isoscope
