// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "core/evaluate/affine_evaluator.h"

namespace isoscope {

/// Writes the first forms.size() coordinates of the pieces as affine forms (centers, slopes and errors,
/// batchLanes of each, one array behind the other), roundings and the spread of bundles (may be null)
/// included; for the first `count` lanes. Those behind, up to a whole vector, hold the last of these forms.
void writeRayPieceForms(const PieceColumns& pieces, const RaySpread* spread, std::size_t count,
                        std::span<double* const> forms);

}  // namespace isoscope
