// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/function/builtins/builtin.h"
#include "core/language/functions/function_expression_parser.h"
#include "core/language/tokens/token_stream.h"

namespace isoscope {

/// `function` statements: the forms of docs/povray/operators.md, section 1. A mistake is reported once, the
/// body is left behind, and the value has no valid function, so that naming it later is no further mistake.
class FunctionParser {
  public:
    explicit FunctionParser(TokenStream& tokens) : tokens_(tokens) {}

    /// The parameter list, if there is one, and the block; the word `function` has been read.
    FunctionValue parse();
    /// The same where POV-Ray takes a formula alone; of a pattern, a pigment and the like is warned.
    FunctionValue parseFormula();
    /// The body behind its `{`, with the `}` that ends it, or up to the end of the text for `untilEnd`.
    /// Empty names mean x, y, z.
    FunctionValue parseBody(std::vector<std::string> parameterNames, bool untilEnd = false);

    /// What stands between the braces of the function read last; empty when they are in different files.
    const SourceRange& bodyRange() const { return bodyRange_; }

  private:
    bool parseParameterList(std::vector<std::string>& names);
    bool acceptableParameter(const Token& name);
    bool parseForm(const std::string& word, FunctionValue& value);
    void parseExpression(FunctionScope& scope, FunctionValue& value, bool untilEnd);
    void parseInternal(FunctionValue& value);
    void parsePattern(FunctionValue& value);
    void parseTransform(FunctionValue& value);
    void parseSpline(FunctionValue& value);
    void parsePigment(FunctionValue& value);
    void keep(FunctionScope& scope, std::vector<NodeId> results, FunctionValue& value);
    void endBody(bool failed, std::uint32_t begin, bool untilEnd);

    ParseContext& context() { return tokens_.context(); }

    TokenStream& tokens_;
    SourceRange bodyRange_;
    SourceRange startRange_;
    std::optional<Token> form_;  ///< `pattern` and the like, with which the body begins
    bool failed_ = false;
};

/// A built-in as a function of its point and parameters. Built once for each noise generator and shared.
FunctionValue builtinFunction(const Builtin& builtin, int noiseGenerator);

}  // namespace isoscope
