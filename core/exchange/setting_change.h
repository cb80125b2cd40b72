// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>

#include "core/language/parse.h"
#include "core/text/text_change.h"

namespace isoscope {

/// How to give an isosurface of the parsed text another accuracy or max_gradient (`role`): its number, or
/// expression, is replaced by `number`; where the statement has none, one is inserted behind the function.
/// Nothing for other roles, and when the statement does not stand in the user's own text.
std::optional<TextChange> settingChange(const ParseResult& parsed, std::size_t isosurface, ParameterRole role,
                                        const std::string& number);

/// How to give it `evaluate P0, P1, P2`: the three numbers of a statement that has it are replaced; else it
/// is inserted behind the function. Nothing when the statement does not stand in the user's own text.
std::optional<TextChange> evaluateChange(const ParseResult& parsed, std::size_t isosurface,
                                         const std::array<double, 3>& numbers);

/// The same for max_gradient, for statements of include files, too: TextChange::range names the file.
std::optional<TextChange> gradientChangeAnywhere(const ParseResult& parsed, std::size_t isosurface,
                                                 const std::string& number);

}  // namespace isoscope
