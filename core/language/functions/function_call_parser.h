// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/function/builtins/builtin.h"
#include "core/language/functions/function_expression_parser.h"
#include "core/language/functions/function_words.h"

namespace isoscope {

/// Calls inside a function body: elementary functions, `sum` and `prod`, declared functions and built-ins.
/// The name has been read; the parenthesis has not. Literal parameters of built-ins become sliders.
class FunctionCallParser {
  public:
    explicit FunctionCallParser(FunctionExpressionParser& expressions)
        : expressions_(expressions), scope_(expressions.scope()), tokens_(expressions.tokens()) {}

    /// A call of an elementary function, of `sum` or of `prod`; the name must be one of function_words.h.
    /// After a mistake, which has been reported, the operand is 0.
    FunctionOperand parseElementary(const Token& name, bool combining);
    /// A call of a declared function; built-ins declared by functions.inc are recognised by
    /// FunctionValue::name.
    FunctionOperand parseCall(const Token& name, const FunctionValue& function, bool combining);
    /// A built-in although functions.inc has not been read: accepted, with a warning.
    FunctionOperand parseUndeclaredBuiltin(const Token& name, const Builtin& builtin, bool combining);

  private:
    struct Argument {
        FunctionOperand operand;
        SourceRange range;
    };

    /// The arguments in parentheses; `combineAll` for `pow`, whose second argument combines constants too.
    std::vector<Argument> parseArguments(const Token& name, bool combining, bool combineAll = false);
    FunctionOperand applyElementary(const Token& name, const ElementaryFunction& function,
                                    const std::vector<Argument>& arguments);
    FunctionOperand applyPower(const std::vector<Argument>& arguments);
    FunctionOperand parseLoop(const Token& name, Operation operation);
    FunctionOperand parseLoopBody(const Token& name, Operation operation, const Token& variable);

    FunctionOperand parseBuiltinCall(const Token& name, const Builtin& builtin, bool combining);
    NodeId builtinArgument(const Builtin& builtin, int index, const Argument& argument);
    /// `.x`, `.red`, ... behind a call with several results; the node of that component.
    FunctionOperand parseMember(const Token& name, const std::vector<NodeId>& components);
    FunctionOperand failCount(const Token& name, const std::string& takes, int wanted, int given);

    SourceRange callRange(const Token& name) const;
    bool failed() const { return expressions_.failed(); }

    FunctionExpressionParser& expressions_;
    FunctionScope& scope_;
    TokenStream& tokens_;
};

/// The components of a function's result that is called `function(arguments)`: one for a field, three for a
/// vector, five for a colour.
std::vector<NodeId> callComponents(FunctionGraph& graph, const Function& function,
                                   std::span<const NodeId> arguments);

}  // namespace isoscope
