// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/language/functions/function_operand.h"
#include "core/language/functions/function_scope.h"
#include "core/language/tokens/token_stream.h"

namespace isoscope {

/// Expressions inside `function { }`: operators, operands and calls with the meaning that POV-Ray 3.7 gives
/// them, constants combined while parsing included (docs/povray/operators.md, sections 1 to 6). The first
/// mistake is reported and ends the expression: everything returned after it is without meaning, and the
/// caller leaves the body.
class FunctionExpressionParser {
  public:
    FunctionExpressionParser(TokenStream& tokens, FunctionScope& scope) : tokens_(tokens), scope_(scope) {}

    /// `combining`: whether neighbouring constants are combined here, as POV-Ray does in the body itself and
    /// in first arguments, and not in further arguments.
    FunctionOperand parse(bool combining = true);

    /// Whether a mistake has ended the expression.
    bool failed() const { return failed_; }
    /// What the parsers of calls and operands share with this one.
    TokenStream& tokens() { return tokens_; }
    FunctionScope& scope() { return scope_; }
    ParseContext& context() { return tokens_.context(); }

    /// Reports a mistake at the range, unless one has been reported before.
    FunctionOperand fail(std::string id, const SourceRange& range, std::string message,
                         std::string hint = {});
    /// Ends the expression where the mistake has been reported elsewhere.
    FunctionOperand failSilently();
    /// Reports that `wanted` ("a number, a name or a call") should stand where the next token stands.
    FunctionOperand failExpected(const std::string& wanted);

  private:
    enum Level { orLevel, andLevel, comparisonLevel, sumLevel, productLevel, signLevel };
    struct Term {
        Operation operation = Operation::constant;  ///< what joins it to the left; nothing for the first
        FunctionOperand operand;
        SourceRange operatorRange;
    };

    FunctionOperand parseLevel(int level);
    std::optional<Operation> operationAt(int level);
    FunctionOperand combine(int level, std::vector<Term>& terms);
    FunctionOperand combineSums(std::vector<Term>& terms);
    FunctionOperand combineProducts(std::vector<Term>& terms);
    FunctionOperand divideByConstant(const FunctionOperand& dividend, const Term& divisor);
    FunctionOperand join(Operation operation, const FunctionOperand& left, const FunctionOperand& right);
    FunctionOperand joinConstants(Operation operation, const FunctionOperand& left,
                                  const FunctionOperand& right);

    FunctionOperand parseSigned();
    FunctionOperand parseOperand();
    FunctionOperand parseWord();
    FunctionOperand parseDeclared(const Token& name, const Value& value);
    FunctionOperand parseElement(const Token& name, const ArrayValue& array);
    FunctionOperand declaredNumber(const NumberValue& number);
    FunctionOperand constantOperand(double value);
    FunctionOperand failUnknown(const Token& name);

    TokenStream& tokens_;
    FunctionScope& scope_;
    bool combining_ = true;
    bool failed_ = false;
    int depth_ = 0;
};

}  // namespace isoscope
