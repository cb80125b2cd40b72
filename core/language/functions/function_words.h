// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/function/operation.h"
#include "core/language/parse_context.h"

namespace isoscope {

/// A function of docs/povray/operators.md, sections 3 and 4, with the operation that it is. `sum` and `prod`
/// take a name first; `min` and `max` take any number from two, `select` three or four, `pow` one or two.
struct ElementaryFunction {
    std::string_view name;
    int arguments;  ///< 1 or 2; 0 for those with rules of their own
    Operation operation;
};

const ElementaryFunction* findElementaryFunction(std::string_view name);
inline bool isElementaryFunction(std::string_view name) { return findElementaryFunction(name) != nullptr; }
std::span<const std::string_view> elementaryFunctionNames();

/// `pi`, `clock`, `frame_number`, `image_width` and the like, which a function body may use.
std::optional<double> reservedNumber(std::string_view name, const ParseOptions& options);

/// For words of the scene language that POV-Ray refuses inside a function: what to write instead. Else "".
std::string refusedWordReason(std::string_view word);

}  // namespace isoscope
