// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/language/expressions/expression_parser.h"

namespace isoscope {

/// The functions of the language that may stand in expressions: `sin(...)`, `vcross(...)`, `concat(...)`.
class FunctionCaller {
  public:
    explicit FunctionCaller(ExpressionParser& expressions)
        : expressions_(expressions), tokens_(expressions.tokens_) {}

    /// Whether call() can take the word: the functions that are accepted and not simulated included.
    static bool knows(std::string_view name);
    /// All words that knows() accepts, in no particular order: for completion and "did you mean".
    static std::vector<std::string> names();

    /// Calls the function `name`, which has been taken and is known.
    Operand call(const Token& name);

    /// `( a, b, ... )` with a float each, for a declared function of `count` parameters. Empty after a
    /// mistake.
    std::optional<std::vector<double>> floatArguments(const Token& name, int count);

    /// Skips to behind the parenthesis that closes the arguments at hand.
    void skipArguments();

  private:
    std::optional<std::vector<Operand>> arguments(const Token& name, std::string_view signature);
    bool argument(const Token& name, char kind, std::vector<Operand>& arguments, bool single);
    Operand callDefined();
    /// `vtransform(V, TRANSFORM)` and `vinv_transform`: the vector carried by a declared transform, or back.
    Operand callTransform(const Token& name);
    Operand callDimensions(const Token& name);

    ExpressionParser& expressions_;
    TokenStream& tokens_;
};

}  // namespace isoscope
