// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluate/steps/step_program.h"
#include "core/evaluate/tape/tape_workspace.h"

namespace isoscope {

/// Runs the tape of a workspace of four components on values with gradients, for at least the first `lanes`
/// lanes (1 to batchLanes, rounded up to whole vectors), with the best instruction set of the machine.
void runGradientTape(TapeWorkspace& workspace, std::size_t lanes);

/// Runs other instructions on the workspace's slots in the same way: a SimplifiedTape of its tape.
void runGradientInstructions(TapeWorkspace& workspace, std::span<const Instruction> instructions,
                             std::size_t lanes);

/// Runs a program of such instructions in the same way.
void runGradientProgram(TapeWorkspace& workspace, const StepProgram& program, std::size_t lanes);

}  // namespace isoscope
