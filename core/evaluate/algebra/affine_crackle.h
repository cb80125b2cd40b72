// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "core/function/function_graph.h"

namespace isoscope {

struct AffineForm;
struct FormColumn;

/// Encloses crackle (operands: x, y, z), or what its settings put in its place, along a piece of a ray:
/// between the bounds of the few cell points that can be nearest there.
AffineForm affineCrackle(std::span<const AffineForm> operands, const CrackleSettings& settings);

/// The same of the first `lanes` forms of columns, which have room for whole vectors (8 lanes at most), as
/// `result` has for a's, b's and e's.
void writeAffineCrackle(const std::array<FormColumn, 3>& place, const CrackleSettings& settings,
                        std::size_t lanes, const std::array<double*, 3>& result);

/// Whether affineCrackle() gives more than bounds over all of space.
bool hasCrackleBounds(const CrackleSettings& settings);

}  // namespace isoscope
