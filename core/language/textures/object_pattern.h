// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/function/function_graph.h"
#include "core/language/tokens/token_stream.h"

namespace isoscope {

/// The pattern `object { OBJECT`, with its first brace: a function of x, y, z that is 1 inside the object and
/// 0 outside. Spheres, boxes and planes and CSG of them become formulas, all others are asked. Nothing where
/// there is no object (the block is left behind); else what follows it, up to the brace, has not been read.
std::optional<Function> parseInsideFunction(TokenStream& tokens);

}  // namespace isoscope
