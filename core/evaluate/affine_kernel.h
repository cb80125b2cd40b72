// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluate/tape_workspace.h"

namespace isoscope {

/// Runs the tape of a workspace of three components on affine forms, for at least the first `lanes` lanes (1
/// to batchLanes, rounded up to whole vectors), with the best instruction set of the machine.
void runAffineTape(TapeWorkspace& workspace, std::size_t lanes);

}  // namespace isoscope
