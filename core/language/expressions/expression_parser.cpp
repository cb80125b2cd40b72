// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/expressions/expression_parser.h"

#include <algorithm>
#include <cmath>

#include "core/language/expressions/named_constants.h"
#include "core/language/functions/function_caller.h"
#include "core/language/tokens/nesting_guard.h"
#include "core/language/tokens/povray_refusals.h"
#include "core/language/tokens/unknown_name.h"
#include "core/language/tokens/words.h"

namespace isoscope {

namespace {

/// Numbers closer than this count as equal, and as zero where a truth value is asked for.
constexpr double tolerance = 1e-10;

bool isTrue(double value) { return value >= tolerance || value <= -tolerance; }

std::string shown(const Token& token) {
    if (token.kind == TokenKind::end) return "the statement ends here";
    return "found `" + std::string(token.text.substr(0, 40)) + "`";
}

double compared(std::string_view operation, double a, double b) {
    const bool equal = std::abs(a - b) < tolerance;
    if (operation == "=") return equal;
    if (operation == "!=") return !equal;
    if (operation == "<") return a < b;
    if (operation == "<=") return a < b || equal;
    if (operation == ">") return a > b;
    return a > b || equal;
}

bool isComparison(const Token& token) {
    return token.is("=") || token.is("!=") || token.is("<") || token.is("<=") || token.is(">") ||
           token.is(">=");
}

}  // namespace

std::optional<Value> ExpressionParser::parseValue() {
    const Operand operand = sum();
    if (operand.failed) return std::nullopt;
    context().markStructural(operand.parameter);
    return toValue(operand);
}

std::optional<Value> ExpressionParser::parseDeclared(std::optional<SourceRange>* literal) {
    const Operand operand = sum();
    if (operand.failed) return std::nullopt;
    if (literal) *literal = operand.literal;
    return toValue(operand);
}

std::optional<Value> ExpressionParser::parseDeclaredBehind(const Value& first) {
    first_ = toOperand(first);
    return parseDeclared(nullptr);
}

double ExpressionParser::floatOf(Operand operand, const SourceRange& range) {
    if (operand.failed) return 0;
    context().markStructural(operand.parameter);
    if (operand.isNumber()) return operand.value();
    fail("expected-float", range, "Expected a float, but this is " + operand.kind() + ".",
         operand.isString ? "" : "take one component of it, as in `.x`");
    return 0;
}

NumberValue ExpressionParser::parseNumber() {
    const SourceRange begin = tokens_.peek().range;
    const Operand operand = sum();
    return {floatOf(operand, rangeFrom(begin)), operand.isNumber() ? operand.parameter : -1};
}

double ExpressionParser::parseCondition() {
    const SourceRange begin = tokens_.peek().range;
    return floatOf(full(), rangeFrom(begin));
}

glm::dvec3 ExpressionParser::parseVector() {
    const SourceRange begin = tokens_.peek().range;
    Operand operand = sum();
    consume(operand);
    if (operand.failed) return {0, 0, 0};
    if (operand.vector.count > 3)
        fail("expected-vector", rangeFrom(begin),
             "Expected a vector of three components, but this has " + std::to_string(operand.vector.count) +
                 ".");
    const VectorValue v = widened(operand.vector, std::max(3, operand.vector.count));
    return {v.components[0], v.components[1], v.components[2]};
}

std::string ExpressionParser::parseString() {
    const SourceRange begin = tokens_.peek().range;
    const Operand operand = primary();
    if (operand.failed || operand.isString) return operand.string;
    fail("expected-string", rangeFrom(begin), "Expected a string, but this is " + operand.kind() + ".",
         operand.isNumber() ? "`str(A, 0, 3)` makes a string of a float" : "");
    return {};
}

Color ExpressionParser::parseColor() {
    const Operand operand = colorExpression();
    const auto& c = operand.vector.components;
    return {c[0], c[1], c[2], c[3], c[4]};
}

bool ExpressionParser::atExpression() {
    const Token& token = tokens_.peek();
    switch (token.kind) {
        case TokenKind::number:
        case TokenKind::string: return true;
        case TokenKind::symbol:
            return token.is("(") || token.is("<") || token.is("+") || token.is("-") || token.is("!");
        case TokenKind::end: return false;
        case TokenKind::word: break;
    }
    if (const Value* value = context().symbols.find(token.text))
        return isExpressionValue(*value) || std::holds_alternative<FunctionValue>(value->data) ||
               std::holds_alternative<std::shared_ptr<ArrayValue>>(value->data);
    return isWordFor(WordUse::constant | WordUse::color, token.text) || FunctionCaller::knows(token.text) ||
           isCallableBuiltin(context(), token.text);
}

bool ExpressionParser::parseBareFlag(std::string_view flag) {
    if (!atExpression()) return true;
    const SourceRange start = tokens_.peek().range;
    const bool on = parseBool();
    warnOfSuperfluous(context(), rangeFrom(start), "takes no value behind `" + std::string(flag) + "`.");
    return on;
}

bool ExpressionParser::parseDefined(const std::string& what) {
    if (!tokens_.expect("(", "behind " + what)) return false;
    const Token name = tokens_.nextName();
    bool defined = false;
    if (name.kind != TokenKind::word) {
        fail("bad-name", name.range, "Expected a name behind " + what + " `(`, but " + shown(name) + ".");
    } else {
        const Value* value = context().symbols.find(name.text);
        defined = value || isCallableBuiltin(context(), name.text) || isPredeclared(name.text, context());
        const auto* array = value ? std::get_if<std::shared_ptr<ArrayValue>>(&value->data) : nullptr;
        if (array && tokens_.peek().is("[")) {
            const std::optional<ElementPlace> place = parseElementPlace(*array);
            defined = place && !std::holds_alternative<std::monostate>(place->value().data);
        }
    }
    tokens_.expect(")", "to close " + what);
    return defined;
}

bool ExpressionParser::isExpressionValue(const Value& value) {
    return std::holds_alternative<NumberValue>(value.data) ||
           std::holds_alternative<VectorValue>(value.data) || std::holds_alternative<std::string>(value.data);
}

Operand ExpressionParser::full() {
    const NestingGuard guard(tokens_);
    if (!guard.ok()) return fail({}, {}, {});
    const SourceRange begin = tokens_.peek().range;
    Operand condition = logical();
    if (!tokens_.accept("?")) return condition;
    const bool truth = isTrue(floatOf(condition, rangeFrom(begin)));
    Operand first = full();
    tokens_.expect(":", "and the value for the other case behind `?`");
    Operand second = full();
    Operand& chosen = truth ? first : second;
    context().markStructural(first.parameter);
    context().markStructural(second.parameter);
    chosen.parameter = -1;
    chosen.literal.reset();
    return chosen;
}

Operand ExpressionParser::logical() {
    Operand left = relation();
    while (tokens_.peek().is("|") || tokens_.peek().is("&")) {
        const bool either = tokens_.next().is("|");
        Operand right = relation();
        consume(left);
        consume(right);
        left = combined(left, right, [either](double a, double b) {
            return static_cast<double>(either ? isTrue(a) || isTrue(b) : isTrue(a) && isTrue(b));
        });
    }
    return left;
}

Operand ExpressionParser::relation() {
    Operand left = sum();
    while (isComparison(tokens_.peek())) {
        const Token operation = tokens_.next();
        Operand right = sum();
        if (left.isString && right.isString) {
            const int order = left.string.compare(right.string);
            left = Operand::number(compared(operation.text, order, 0));
            continue;
        }
        consume(left);
        consume(right);
        left = combined(left, right, [&](double a, double b) { return compared(operation.text, a, b); });
    }
    return left;
}

Operand ExpressionParser::sum() {
    Operand left = product();
    while (tokens_.peek().is("+") || tokens_.peek().is("-")) {
        const bool plus = tokens_.next().is("+");
        Operand right = product();
        consume(left);
        consume(right);
        left = combined(left, right, [plus](double a, double b) { return plus ? a + b : a - b; });
    }
    return left;
}

Operand ExpressionParser::product() {
    Operand left = unary();
    while (tokens_.peek().is("*") || tokens_.peek().is("/")) {
        const Token operation = tokens_.next();
        Operand right = unary();
        consume(left);
        consume(right);
        if (operation.is("*")) {
            left = combined(left, right, [](double a, double b) { return a * b; });
            continue;
        }
        bool byZero = false;
        left = combined(left, right, [&byZero](double a, double b) {
            byZero |= b == 0;
            return a / b;
        });
        if (byZero && !right.failed)
            context().warning("division-by-zero", operation.range,
                              "This divides by zero; the result is infinite or no number.");
    }
    return left;
}

Operand ExpressionParser::unary() {
    const Token& token = tokens_.peek();
    const bool minus = token.is("-"), negation = token.is("!");
    if (first_ || (!minus && !negation && !token.is("+"))) return primary();
    const NestingGuard guard(tokens_);
    if (!guard.ok()) return fail({}, {}, {});
    const SourceRange sign = tokens_.next().range;
    Operand operand = unary();
    const std::optional<SourceRange> literal = operand.literal;
    consume(operand);
    if (literal && !negation && literal->file == sign.file &&
        context().sources.slice(*literal).find_first_of("+-") != 0)
        operand.literal = SourceRange{sign.file, sign.begin, literal->end};
    for (std::size_t i = 0; i < static_cast<std::size_t>(operand.vector.count); ++i) {
        double& c = operand.vector.components[i];
        if (minus) c = -c;
        if (negation) c = !isTrue(c);
    }
    return operand;
}

void ExpressionParser::consume(Operand& operand) {
    context().markStructural(operand.parameter);
    operand.parameter = -1;
    operand.literal.reset();
    if (!operand.isString) return;
    if (!operand.failed)
        fail("expected-number", tokens_.lastRange(), "Expected a float or a vector, but this is a string.",
             "`val(S)` makes a float of a string, `concat(S, T)` joins strings");
    operand = Operand::number(0);
    operand.failed = true;
}

Operand ExpressionParser::fail(std::string id, const SourceRange& range, std::string message,
                               std::string hint) {
    if (!message.empty()) context().error(std::move(id), range, std::move(message), std::move(hint));
    Operand operand;
    operand.failed = true;
    return operand;
}

SourceRange ExpressionParser::rangeFrom(const SourceRange& begin) const {
    const SourceRange& last = tokens_.lastRange();
    if (last.file != begin.file || last.end <= begin.begin) return begin;
    return {begin.file, begin.begin, last.end};
}

bool ExpressionParser::reportBareComparison() {
    const Token& token = tokens_.peek();
    if (!isComparison(token) && !token.is("&") && !token.is("|") && !token.is("?")) return false;
    fail("needs-parentheses", token.range,
         "`" + std::string(token.text) + "` needs parentheses around the whole comparison here.",
         "write `(A " + std::string(token.text) + " B" + (token.is("?") ? " : C)`" : ")`"));
    return true;
}

void ExpressionParser::reportUnknown(const Token& word) { reportUnknownName(context(), word); }

}  // namespace isoscope
