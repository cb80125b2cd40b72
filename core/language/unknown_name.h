// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "core/language/parse_context.h"
#include "core/language/token.h"

namespace isoscope {

/// Says that a word is not declared, and what was probably meant: a name much like it, or one of an include
/// file that is missing.
void reportUnknownName(ParseContext& context, const Token& word);

/// The program's own include file that declares `name`, or "".
std::string includeThatDeclares(std::string_view name);

/// Whether `name` is a built-in of functions.inc, which has been included but declares nothing itself.
bool isCallableBuiltin(const ParseContext& context, std::string_view name);
/// The built-in as if it had been declared. Its name must be callable.
FunctionValue builtinFunction(const ParseContext& context, std::string_view name);

}  // namespace isoscope
