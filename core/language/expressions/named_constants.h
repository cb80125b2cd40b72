// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "core/language/expressions/operand.h"
#include "core/language/parse_context.h"

namespace isoscope {

/// The value of a WordUse::constant: `x`, `pi`, `clock`, `version`, ...; empty for other words. As in
/// POV-Ray, all that describe an animation are 0 without one.
std::optional<Operand> namedConstant(std::string_view word, const ParseContext& context);

}  // namespace isoscope
