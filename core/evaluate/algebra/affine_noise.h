// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/function/function_graph.h"

namespace isoscope {

/// One lane of an affine form a + b s + [-e, e]; e is not finite where nothing is known (+infinity, NaN) or
/// where there is certainly no value (-infinity).
struct AffineForm {
    double a = 0;
    double b = 0;
    double e = 0;
};

/// Encloses crackle (operands: x, y, z) along a piece of a ray. It has no certain bounds, since it looks at a
/// limited number of cells: what is returned holds between its jumps.
AffineForm affineCrackle(std::span<const AffineForm> operands, const CrackleSettings& settings);

}  // namespace isoscope
