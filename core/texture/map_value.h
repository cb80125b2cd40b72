// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/function/graph_builder.h"
#include "core/scene/pigment.h"

namespace isoscope {

/// How such a map looks up the values of its pattern: a list blends neighbours where frequency, phase or wave
/// form lead between its whole numbers, as POV-Ray does.
MapKind lookupOf(MapKind kind, const Pattern& pattern);

/// What a map makes of the value of its pattern, for one channel: `choices` are the entries' own values
/// there, at `positions` (weights of MapKind::average, which asks for no value). At least one entry.
///
/// Positions need not be in order: POV-Ray looks at the last entry first, then for the first one that is not
/// below the value. Checked against POV-Ray 3.7.
Expression mapValue(MapKind kind, Expression value, std::span<const double> positions,
                    std::span<const Expression> choices);

}  // namespace isoscope
