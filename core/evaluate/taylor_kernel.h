// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/evaluate/steps/step_program.h"
#include "core/evaluate/taylor_evaluator.h"
#include "core/evaluate/tape/tape_workspace.h"

namespace isoscope {

/// Writes the coordinates of the places, with their way along the reach, to the arguments of a workspace of
/// seven components; the derivatives stand there already.
void writeTangentArguments(const RayPlaces& places, std::size_t lanes, TapeWorkspace& workspace);

/// Runs instructions on the slots of a workspace of seven components (TangentNumber) for at least the first
/// `lanes` lanes, with the best instruction set of the machine.
void runTangentInstructions(TapeWorkspace& workspace, std::span<const Instruction> instructions,
                            std::size_t lanes);

/// Runs a program of such instructions in the same way.
void runTangentProgram(TapeWorkspace& workspace, const StepProgram& program, std::size_t lanes);

}  // namespace isoscope
