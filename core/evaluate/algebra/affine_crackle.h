// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/function/function_graph.h"

namespace isoscope {

struct AffineForm;

/// Encloses crackle (operands: x, y, z), or what its settings put in its place, along a piece of a ray:
/// between the bounds of the few cell points that can be nearest there.
AffineForm affineCrackle(std::span<const AffineForm> operands, const CrackleSettings& settings);

/// Whether affineCrackle() gives more than bounds over all of space.
bool hasCrackleBounds(const CrackleSettings& settings);

}  // namespace isoscope
