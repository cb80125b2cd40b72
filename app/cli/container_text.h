// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "core/shapes/isosurface/isosurface.h"

namespace isoscope::cli {

/// `box{<a,b,c>,<d,e,f>}`, its corners in any order, or `sphere{<a,b,c>,r}` with plain finite numbers and a
/// radius above 0; nothing for any other text.
std::optional<Container> readContainer(const std::string& text);

}  // namespace isoscope::cli
