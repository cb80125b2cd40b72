// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/evaluate/jumps/affine_cases.h"
#include "core/evaluate/jumps/affine_sides.h"
#include "core/evaluate/steps/step_program.h"
#include "core/evaluate/tape/tape_workspace.h"

namespace isoscope {

/// Runs instructions on affine forms as runAffineInstructions() does, jumps by the sides that `cases` tells;
/// fills it for at least the first `lanes` lanes. A coordinate that is the same all along a piece may be a
/// whole number (`wholeCoordinates`), and so may what is made of it.
void runAffineCases(TapeWorkspace& workspace, std::span<const Instruction> instructions, CaseLanes& cases,
                    std::size_t lanes, bool wholeCoordinates);

/// The same without whole coordinates by a program for forms by cases, made of such instructions. False,
/// without effect, where instructions are better.
bool runAffineCases(TapeWorkspace& workspace, const StepProgram& program, CaseLanes& cases,
                    std::size_t lanes);

/// Both for the sides of one place of each piece (SideLanes).
void runAffineSides(TapeWorkspace& workspace, std::span<const Instruction> instructions, SideLanes& sides,
                    std::size_t lanes, bool wholeCoordinates);
bool runAffineSides(TapeWorkspace& workspace, const StepProgram& program, SideLanes& sides,
                    std::size_t lanes);

}  // namespace isoscope
