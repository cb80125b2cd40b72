// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/evaluate/steps/step_program.h"
#include "core/evaluate/tape/tape_workspace.h"

namespace isoscope {

/// Runs the tape of a workspace of one component on plain numbers, for at least the first `lanes` lanes (1 to
/// batchLanes, rounded up to whole vectors), with the best instruction set of the machine.
void runPointTape(TapeWorkspace& workspace, std::size_t lanes);
/// The same for the instructions of a shortened tape.
void runPointInstructions(TapeWorkspace& workspace, std::span<const Instruction> instructions,
                          std::size_t lanes);

/// The same for all batchLanes lanes, by the program of that tape.
void runPointProgram(TapeWorkspace& workspace, const StepProgram& program);

}  // namespace isoscope
