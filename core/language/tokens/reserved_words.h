// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/language/expressions/operand.h"
#include "core/language/parse_context.h"

namespace isoscope {

/// Whether a word belongs to the language of POV-Ray 3.7 and cannot be declared.
bool isReservedWord(std::string_view word);
/// All of them, sorted.
const std::vector<std::string_view>& reservedWords();

/// Whether a word is a value by itself: `x`, `pi`, `clock`, ...
bool isConstantWord(std::string_view word);

/// Whether a word that is not a function may begin an expression: `x`, `pi`, `rgb`, `clock`, ...
bool isExpressionWord(std::string_view word);

/// The value of `x`, `pi`, `clock`, `version`, ...; empty for other words.
std::optional<Operand> reservedConstant(std::string_view word, const ParseContext& context);

}  // namespace isoscope
