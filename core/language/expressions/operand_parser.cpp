// SPDX-License-Identifier: GPL-3.0-or-later
// The operands of ExpressionParser: literals, names, members, calls, elements of arrays.
#include <cmath>

#include "core/evaluate/reference_evaluator.h"
#include "core/function/builtins/builtin.h"
#include "core/image/brightness.h"
#include "core/language/expressions/expression_parser.h"
#include "core/language/expressions/named_constants.h"
#include "core/language/functions/function_caller.h"
#include "core/language/objects/spline_parser.h"
#include "core/language/tokens/nesting_guard.h"
#include "core/language/tokens/unknown_name.h"

namespace isoscope {

Operand ExpressionParser::primary() {
    if (first_) {
        Operand operand = std::move(*first_);
        first_.reset();
        return withMembers(std::move(operand));
    }
    const Token& token = tokens_.peek();
    switch (token.kind) {
        case TokenKind::number: {
            const Token number = tokens_.next();
            Operand operand = Operand::number(number.number);
            operand.literal = number.range;
            return operand;
        }
        case TokenKind::string: return Operand::text(tokens_.next().string);
        case TokenKind::word: return word();
        case TokenKind::symbol:
            if (token.is("(")) return parenthesised();
            if (token.is("<")) return withMembers(vectorLiteral());
            return fail(
                "expected-expression", token.range,
                "Expected a number, a vector or a name, but found `" + std::string(token.text) + "`.");
        case TokenKind::end: break;
    }
    return fail("expected-expression", token.range,
                "Expected a number, a vector or a name, but the text or statement ends here.");
}

Operand ExpressionParser::parenthesised() {
    tokens_.next();
    Operand operand = full();
    tokens_.expect(")", "to close the parenthesis");
    return withMembers(std::move(operand));
}

Operand ExpressionParser::vectorLiteral() {
    const NestingGuard guard(tokens_);
    if (!guard.ok()) return fail({}, {}, {});
    const SourceRange begin = tokens_.next().range;
    VectorValue vector;
    vector.count = 0;
    bool failed = false;
    for (;;) {
        const SourceRange at = tokens_.peek().range;
        const Operand component = sum();
        const double value = floatOf(component, rangeFrom(at));
        failed = component.failed;
        if (vector.count < 5) vector.components[static_cast<std::size_t>(vector.count)] = value;
        ++vector.count;
        // POV-Ray forgives missing commas, and one too many at the end.
        if (failed || (!tokens_.accept(",") && !atExpression()) || tokens_.peek().is(">")) break;
    }
    if (failed) {
        // One message is enough for one vector.
        while (!tokens_.peek().is(">") && !tokens_.peek().is("}") && !tokens_.peek().is(";") &&
               tokens_.peek().kind != TokenKind::end)
            if (tokens_.next().is("{")) tokens_.skipBlock();
        tokens_.accept(">");
        return fail({}, {}, {});
    }
    const bool isClosed = tokens_.expect(">", "to close the vector");
    if (!isClosed && vector.count < 2) return fail({}, {}, {});
    if (vector.count < 2 || vector.count > 5)
        return fail("bad-vector", rangeFrom(begin),
                    "A vector has 2 to 5 components, not " + std::to_string(vector.count) + ".");
    return Operand::of(vector);
}

Operand ExpressionParser::withMembers(Operand operand) {
    while (tokens_.accept(".")) {
        const Token member = tokens_.peek();
        // POV-Ray knows `grey` in functions only.
        const bool gray = member.is("gray");
        const std::optional<int> index =
            member.kind == TokenKind::word ? componentIndex(member.text) : std::nullopt;
        if (!gray && !index)
            return fail("no-component", member.range,
                        "Expected a component such as `x`, `red` or `gray` behind `.`, but found `" +
                            std::string(member.text.substr(0, 40)) + "`.");
        tokens_.next();
        // What is missing to a brightness counts as 0.
        const int needed = gray ? 1 : *index + 1;
        if (operand.failed) return operand;
        if (operand.isString || operand.vector.count < needed)
            return fail(
                "no-component", member.range,
                "`." + std::string(member.text) + "` asks for a component that " +
                    (operand.isNumber() || operand.isString
                         ? operand.kind() + " does not have."
                         : "a vector of " + std::to_string(operand.vector.count) + " does not have."));
        context().markStructural(operand.parameter);
        const auto& c = operand.vector.components;
        operand = Operand::number(gray ? brightness(c[0], c[1], c[2]) : c[static_cast<std::size_t>(*index)]);
    }
    return operand;
}

Operand ExpressionParser::word() {
    if (atColor()) return colorExpression();
    const Token name = tokens_.next();
    if (Value* value = context().symbols.find(name.text)) return declared(name, value);
    if (FunctionCaller::knows(name.text)) {
        const NestingGuard guard(tokens_);
        if (!guard.ok()) return fail({}, {}, {});
        return withMembers(FunctionCaller(*this).call(name));
    }
    if (std::optional<Operand> constant = namedConstant(name.text, context())) return withMembers(*constant);
    if (isCallableBuiltin(context(), name.text))
        return withMembers(call(name, builtinFunction(context(), name.text)));
    reportUnknown(name);
    // Its arguments, index or block make no sense without it.
    if (tokens_.peek().is("(")) {
        int depth = 0;
        do {
            const Token token = tokens_.next();
            if (token.kind == TokenKind::end) break;
            depth += token.is("(") - token.is(")");
        } while (depth > 0);
    }
    // Nor do its members.
    while (tokens_.accept("."))
        if (tokens_.peek().kind == TokenKind::word) tokens_.next();
    return fail({}, {}, {});
}

Operand ExpressionParser::declared(const Token& name, Value* value) {
    if (std::optional<Operand> operand = toOperand(*value)) return withMembers(std::move(*operand));
    if (const auto* function = std::get_if<FunctionValue>(&value->data)) {
        const FunctionValue copy = *function;
        return withMembers(call(name, copy));
    }
    if (const auto* spline = std::get_if<std::shared_ptr<const Spline>>(&value->data)) {
        const std::shared_ptr<const Spline> copy = *spline;
        return withMembers(SplineParser(tokens_).call(copy));
    }
    if (const auto* array = std::get_if<std::shared_ptr<ArrayValue>>(&value->data)) {
        const std::optional<ElementPlace> place = parseElementPlace(*array);
        if (!place) return fail({}, {}, {});
        const Value& element = place->value();
        if (std::optional<Operand> operand = toOperand(element)) return withMembers(std::move(*operand));
        if (const auto* spline = std::get_if<std::shared_ptr<const Spline>>(&element.data)) {
            const std::shared_ptr<const Spline> copy = *spline;
            return withMembers(SplineParser(tokens_).call(copy));
        }
        if (std::holds_alternative<std::monostate>(element.data))
            return fail("unset-element", name.range,
                        "This element of `" + std::string(name.text) + "` has not been given a value.");
        return fail("expected-expression", name.range,
                    "Expected a float, vector, color or string, but this element of `" +
                        std::string(name.text) + "` is " + kindOf(element) + ".");
    }
    if (std::holds_alternative<OpaqueValue>(value->data) && tokens_.accept("(")) {
        // That it is not simulated has been said where it was declared.
        FunctionCaller(*this).skipArguments();
        VectorValue nothing;
        return withMembers(Operand::of(nothing));
    }
    return fail("expected-expression", name.range,
                "Expected a float, vector, color or string, but `" + std::string(name.text) + "` is " +
                    kindOf(*value) + ".");
}

Operand ExpressionParser::call(const Token& name, const FunctionValue& function) {
    const NestingGuard guard(tokens_);
    if (!guard.ok()) return fail({}, {}, {});
    const auto arguments = FunctionCaller(*this).floatArguments(name, function.function.argumentCount);
    if (!arguments || !function.function.valid()) return fail({}, {}, {});
    // A value that is computed now cannot follow a slider later.
    context().markStructural(function.function);
    if (!tokens_.charge(function.function.graph->size() / 4 + 1, name.range)) return fail({}, {}, {});
    ReferenceEvaluator evaluator(function.function);
    VectorValue result;
    const std::size_t count = std::min<std::size_t>(function.function.results.size(), 5);
    result.count = static_cast<int>(count);
    result.color = count == 5;
    for (std::size_t i = 0; i < count; ++i)
        result.components[i] = evaluator.evaluate(*arguments, context().parameterTable, i);
    return Operand::of(result);
}

std::optional<ElementPlace> ExpressionParser::parseElementPlace(std::shared_ptr<ArrayValue> array) {
    // An index may hold an element whose index holds an element, and so on.
    const NestingGuard guard(tokens_);
    if (!guard.ok()) return std::nullopt;
    ElementPlace place{std::move(array), 0};
    for (;;) {
        const std::vector<int>& dimensions = place.array->dimensions;
        place.element = 0;
        for (std::size_t d = 0; d < dimensions.size(); ++d) {
            if (!tokens_.expect("[", "and an index for each of the " + std::to_string(dimensions.size()) +
                                         " dimensions of the array"))
                return std::nullopt;
            const SourceRange at = tokens_.peek().range;
            const double written = parseFloat();
            const double index = written < 0 ? std::floor(written + 1e-10) : std::trunc(written + 1e-10);
            const SourceRange range = rangeFrom(at);
            if (!tokens_.expect("]", "to close the index")) return std::nullopt;
            if (!(index >= 0 && index < dimensions[d])) {
                fail("index-out-of-range", range,
                     "This index is outside the array: expected 0 to " + std::to_string(dimensions[d] - 1) +
                         ".");
                return std::nullopt;
            }
            place.element =
                place.element * static_cast<std::size_t>(dimensions[d]) + static_cast<std::size_t>(index);
        }
        const auto* inner = std::get_if<std::shared_ptr<ArrayValue>>(&place.value().data);
        if (!inner || !tokens_.peek().is("[")) return place;
        place.array = std::shared_ptr<ArrayValue>(*inner);
    }
}

std::optional<int> ExpressionParser::parseComponentName() {
    const Token member = tokens_.next();
    const std::optional<int> index =
        member.kind == TokenKind::word ? componentIndex(member.text) : std::nullopt;
    if (!index) fail("no-component", member.range, "Expected a component such as `x` or `red` behind `.`.");
    return index;
}

}  // namespace isoscope
