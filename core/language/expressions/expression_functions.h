// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "core/function/operation.h"
#include "core/language/expressions/operand.h"
#include "core/language/tokens/token_stream.h"

namespace isoscope {

/// A call whose arguments have been read and checked.
struct ExpressionCall {
    TokenStream& tokens;
    std::string name;
    SourceRange range;
    std::vector<Operand> arguments;
    Operation operation = Operation::count_;  ///< which the function is; count_: it is none

    /// Argument i, from 0 on: it must have been given, with the kind that the signature asks for.
    double number(std::size_t i) const { return arguments[i].value(); }
    /// The first three components; a float given for a vector stands for all three.
    glm::dvec3 vector(std::size_t i) const;
    const std::string& string(std::size_t i) const { return arguments[i].string; }
    /// Reports, at the place of the call, that an argument is outside the domain of the function, which then
    /// returns a neutral value.
    void error(std::string message) const;
    void warning(std::string message) const;
};

/// One function of the scene language. `signature` has a letter for each argument: f float, v vector of three
/// components, w of five, s string; `?` behind it makes the last one optional, `*` lets it come any number of
/// times, or not at all.
struct ExpressionFunction {
    std::string_view name;
    std::string_view signature;
    Operand (*evaluate)(const ExpressionCall&);
    Operation operation = Operation::count_;  ///< that `evaluate` finds in the call; count_: it needs none
};

/// The functions by what they return. Built on first use; may be called from any thread.
const std::vector<ExpressionFunction>& floatFunctions();
const std::vector<ExpressionFunction>& vectorFunctions();
const std::vector<ExpressionFunction>& stringFunctions();

/// In any of the three tables; null when it is in none.
const ExpressionFunction* findExpressionFunction(std::string_view name);

}  // namespace isoscope
