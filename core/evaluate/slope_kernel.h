// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluate/affine_evaluator.h"
#include "core/evaluate/tape/tape_workspace.h"

namespace isoscope {

/// Writes the coordinates along the pieces, with their slopes and what rounding makes of points, to the
/// arguments of a workspace of six components.
void writeSlopeArguments(const RayPieces& pieces, const RaySpread& spread, std::size_t lanes,
                         TapeWorkspace& workspace);

/// Runs the tape of a workspace of six components (SlopeNumber) for at least the first `lanes` lanes, with
/// the best instruction set of the machine.
void runSlopeTape(TapeWorkspace& workspace, std::size_t lanes);

}  // namespace isoscope
