// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/scene/material.h"

namespace isoscope {

/// Everything that moves the point of a pattern, in the order in which it is written: what the entries of its
/// map are looked up through as well.
std::vector<PatternWarp> allWarps(const Pattern& pattern);

/// The material as an entry of a map shows it whose pattern has these warps: its own patterns are looked up
/// through them.
Material warped(const Material& material, std::span<const PatternWarp> warps);

}  // namespace isoscope
