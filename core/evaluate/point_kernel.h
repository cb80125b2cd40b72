// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/evaluate/steps/step_program.h"
#include "core/evaluate/tape/tape_workspace.h"

namespace isoscope {

/// Runs the tape of a workspace of one component on plain numbers, for at least the first `lanes` lanes (1 to
/// batchLanes, rounded up to whole vectors), with the best instruction set of the machine.
void runPointTape(TapeWorkspace& workspace, std::size_t lanes);
/// Runs the instructions of a shortened tape in the same way.
void runPointInstructions(TapeWorkspace& workspace, std::span<const Instruction> instructions,
                          std::size_t lanes);

/// Runs the program of that tape for all batchLanes lanes.
void runPointProgram(TapeWorkspace& workspace, const StepProgram& program);

}  // namespace isoscope
