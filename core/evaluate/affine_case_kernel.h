// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/evaluate/algebra/affine_cases.h"
#include "core/evaluate/tape/tape_workspace.h"

namespace isoscope {

/// Runs instructions on affine forms as runAffineInstructions() does, jumps by the sides that `cases` tells;
/// fills it for at least the first `lanes` lanes.
void runAffineCases(TapeWorkspace& workspace, std::span<const Instruction> instructions, CaseLanes& cases,
                    std::size_t lanes);

}  // namespace isoscope
