// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "core/language/expressions/operand.h"
#include "core/language/parse_context.h"

namespace isoscope {

/// Whether the word has a value before the text begins, and the text has neither declared it anew nor
/// undefined it.
bool isPredeclared(std::string_view word, const ParseContext& context);

/// The value of a WordUse::constant: `x`, `pi`, `clock`, `version`, ...; empty for other words, and for
/// predeclared ones that are gone. As in POV-Ray, all that describe an animation are 0 without one.
std::optional<Operand> namedConstant(std::string_view word, const ParseContext& context);

}  // namespace isoscope
