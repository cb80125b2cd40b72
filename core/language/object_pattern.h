// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/function/function_graph.h"
#include "core/language/token_stream.h"

namespace isoscope {

/// The block of the pattern `object { OBJECT }`, braces included: a function of x, y, z that is 1 inside the
/// object and 0 outside. Spheres, boxes and planes and CSG of them are understood; nothing for others (the
/// block is left behind).
std::optional<Function> parseInsideFunction(TokenStream& tokens);

}  // namespace isoscope
