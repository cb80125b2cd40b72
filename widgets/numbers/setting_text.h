// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/exchange/setting_change.h"

namespace isoscope {

/// settingChange() with the number as a person writes it.
std::optional<TextChange> settingChange(const ParseResult& parsed, std::size_t isosurface, ParameterRole role,
                                        double value);

/// The changes for all isosurfaces whose statements stand in the user's own text, from the last to the first,
/// so that each leaves the places of the others alone.
std::vector<TextChange> settingChanges(const ParseResult& parsed, ParameterRole role, double value);

}  // namespace isoscope
