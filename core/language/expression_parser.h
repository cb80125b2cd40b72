// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string>

#include "core/language/token_stream.h"

namespace isoscope {

/// Float, vector, colour and string expressions of the scene language, evaluated as they are read
/// (spec/scene-language-usage.md lists what real scenes use). On a mistake a diagnostic is reported, the tokens
/// already taken stay taken, and the result is empty or a neutral value; nothing throws.
class ExpressionParser {
  public:
    explicit ExpressionParser(TokenStream& tokens) : tokens_(tokens) {}

    /// Any expression: number, vector, colour or string.
    std::optional<Value> parseValue();
    /// A float; 0 after a mistake.
    NumberValue parseNumber();
    double parseFloat() { return parseNumber().value; }
    bool parseBool() { return parseFloat() != 0; }
    /// A vector; a float stands for the same value on all axes.
    glm::dvec3 parseVector();
    /// `color`, `rgb`, `rgbf`, `rgbt`, `rgbft`, `red 1 green ...`, a declared colour, or a bare vector.
    Color parseColor();
    std::string parseString();
    /// Whether the token at hand can begin an expression.
    bool atExpression();

  private:
    TokenStream& tokens_;
};

}  // namespace isoscope
