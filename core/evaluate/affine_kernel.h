// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluate/affine_evaluator.h"
#include "core/evaluate/steps/step_program.h"
#include "core/evaluate/tape/tape_workspace.h"

namespace isoscope {

/// Runs the tape of a workspace of three components on affine forms, for at least the first `lanes` lanes (1
/// to batchLanes, rounded up to whole vectors), with the best instruction set of the machine.
void runAffineTape(TapeWorkspace& workspace, std::size_t lanes);

/// Runs other instructions on the workspace's slots in the same way: a part of its tape, or a SimplifiedTape.
void runAffineInstructions(TapeWorkspace& workspace, std::span<const Instruction> instructions,
                           std::size_t lanes);

/// Runs a program of such instructions in the same way, after writing the forms of the pieces (see
/// writeRayPieceForms) into the arguments.
void runAffineProgram(TapeWorkspace& workspace, const StepProgram& program, const PieceColumns& pieces,
                      const RaySpread* spread, std::size_t lanes);

/// Runs the steps of one stretch of such a program, which is one of this workspace. False, without effect,
/// where instructions are better.
bool runAffineSteps(const TapeWorkspace& workspace, const StepProgram& program,
                    const StepProgram::Stretch& stretch, std::size_t lanes);

/// Adds offset +- error to the first `count` forms, whole vectors of them: centers and errors are what
/// becomes of them, and may be where they have been.
void widenAffineForms(const AffineLanes& forms, double offset, double error, std::size_t count,
                      double* centers, double* errors);

}  // namespace isoscope
