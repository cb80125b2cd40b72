// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "core/function/operation.h"

namespace isoscope {

/// A function of docs/povray/operators.md, sections 3 and 4, with the operation that it is. `sum` and `prod`
/// take a name first; `min` and `max` take any number from two, `select` three or four, `pow` one or two.
struct ElementaryFunction {
    std::string_view name;
    int arguments;  ///< 1 or 2; 0 for those with rules of their own
    Operation operation;
};

/// Null for what is no WordUse::elementaryFunction.
const ElementaryFunction* findElementaryFunction(std::string_view name);

/// Whether a parameter of a function, or what `sum` and `prod` count with, may have the name. Of the words of
/// the language only `x`, `y`, `z`, `u` and `v` may.
bool mayNameVariable(std::string_view name);

/// For words of the scene language that POV-Ray refuses inside a function: what to write instead. Else "".
std::string refusedWordReason(std::string_view word);

}  // namespace isoscope
