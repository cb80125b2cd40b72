// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/functions/function_expression_parser.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/language/expressions/expression_parser.h"
#include "core/language/expressions/named_constants.h"
#include "core/language/functions/function_call_parser.h"
#include "core/language/functions/function_words.h"
#include "core/language/tokens/unknown_name.h"
#include "core/language/tokens/words.h"

namespace isoscope {

namespace {

/// Parentheses and calls nested deeper than this are a mistake, not a surface; the parser's own stack stays
/// small.
constexpr int depthLimit = 200;

double combineConstants(Operation operation, double a, double b) {
    switch (operation) {
        case Operation::add: return a + b;
        case Operation::subtract: return a - b;
        case Operation::multiply: return a * b;
        case Operation::divide: return a / b;
        // Unlike at run time, a NaN is greater than nothing here.
        case Operation::equal: return a == b;
        case Operation::notEqual: return a != b;
        case Operation::less: return a < b;
        case Operation::lessEqual: return a <= b;
        case Operation::greater: return a > b;
        default: return a >= b;
    }
}

std::string found(const Token& token) {
    if (token.kind == TokenKind::end) return "the end of the text";
    if (token.kind == TokenKind::string) return "a string";
    return "`" + std::string(token.text) + "`";
}

}  // namespace

FunctionOperand FunctionExpressionParser::fail(std::string id, const SourceRange& range, std::string message,
                                               std::string hint) {
    if (!failed_) context().error(std::move(id), range, std::move(message), std::move(hint));
    return failSilently();
}

FunctionOperand FunctionExpressionParser::failSilently() {
    failed_ = true;
    return {scope_.graph().constant(0)};
}

FunctionOperand FunctionExpressionParser::failExpected(const std::string& wanted) {
    const Token& token = tokens_.peek();
    return fail("unexpected-token", token.range,
                "Expected " + wanted + " here, but found " + found(token) + ".");
}

FunctionOperand FunctionExpressionParser::parse(bool combining) {
    const bool before = combining_;
    combining_ = combining;
    ++depth_;
    FunctionOperand result;
    if (depth_ > depthLimit)
        result =
            fail("too-deep", tokens_.peek().range,
                 "Parentheses and calls are nested more than " + std::to_string(depthLimit) + " deep here.",
                 "declare the inner part as a function of its own");
    else
        result = parseLevel(orLevel);
    --depth_;
    combining_ = before;
    return result;
}

std::optional<Operation> FunctionExpressionParser::operationAt(int level) {
    struct Entry {
        const char* symbol;
        int level;
        Operation operation;
    };
    static constexpr std::array<Entry, 12> entries{{{"|", orLevel, Operation::logicalOr},
                                                    {"&", andLevel, Operation::logicalAnd},
                                                    {"=", comparisonLevel, Operation::equal},
                                                    {"!=", comparisonLevel, Operation::notEqual},
                                                    {"<", comparisonLevel, Operation::less},
                                                    {"<=", comparisonLevel, Operation::lessEqual},
                                                    {">", comparisonLevel, Operation::greater},
                                                    {">=", comparisonLevel, Operation::greaterEqual},
                                                    {"+", sumLevel, Operation::add},
                                                    {"-", sumLevel, Operation::subtract},
                                                    {"*", productLevel, Operation::multiply},
                                                    {"/", productLevel, Operation::divide}}};
    const Token& token = tokens_.peek();
    if (token.kind != TokenKind::symbol) return std::nullopt;
    for (const Entry& entry : entries)
        if (entry.level == level && token.text == entry.symbol) return entry.operation;
    return std::nullopt;
}

FunctionOperand FunctionExpressionParser::parseLevel(int level) {
    if (level == signLevel) return parseSigned();
    std::vector<Term> terms(1);
    terms[0].operand = parseLevel(level + 1);
    while (!failed_) {
        const std::optional<Operation> operation = operationAt(level);
        if (!operation) break;
        Term term;
        term.operation = *operation;
        term.operatorRange = tokens_.next().range;
        term.operand = parseLevel(level + 1);
        terms.push_back(term);
    }
    if (failed_ || terms.size() == 1) return terms[0].operand;
    return combine(level, terms);
}

FunctionOperand FunctionExpressionParser::combine(int level, std::vector<Term>& terms) {
    if (level == sumLevel) return combineSums(terms);
    if (level == productLevel) return combineProducts(terms);
    if (level == comparisonLevel && combining_) {
        // Neighbouring constants are compared first: `a < 2 < 3` is a < (2 < 3).
        std::size_t kept = 0;
        for (std::size_t k = 1; k < terms.size(); ++k) {
            if (terms[kept].operand.constant && terms[k].operand.constant)
                terms[kept].operand =
                    joinConstants(terms[k].operation, terms[kept].operand, terms[k].operand);
            else
                terms[++kept] = terms[k];
        }
        terms.resize(kept + 1);
    }
    FunctionOperand result = terms[0].operand;
    for (std::size_t k = 1; k < terms.size(); ++k)
        result = join(terms[k].operation, result, terms[k].operand);
    return result;
}

FunctionOperand FunctionExpressionParser::combineSums(std::vector<Term>& terms) {
    FunctionOperand result = terms[0].operand;
    for (std::size_t k = 1; k < terms.size(); ++k) {
        const Term& term = terms[k];
        if (combining_ && result.constant && term.operand.constant) {
            result = joinConstants(term.operation, result, term.operand);
            continue;
        }
        // `x - 3 - 2` is x - (3 + 2): constants side by side are combined before they meet the variable.
        FunctionOperand right = term.operand;
        while (combining_ && right.constant && k + 1 < terms.size() && terms[k + 1].operand.constant) {
            const bool sameSign = terms[k + 1].operation == term.operation;
            right = joinConstants(sameSign ? Operation::add : Operation::subtract, right, terms[++k].operand);
        }
        result = join(term.operation, result, right);
    }
    return result;
}

FunctionOperand FunctionExpressionParser::combineProducts(std::vector<Term>& terms) {
    FunctionOperand result = terms[0].operand;
    for (std::size_t k = 1; k < terms.size() && !failed_; ++k) {
        const Term& term = terms[k];
        if (combining_ && result.constant && term.operand.constant)
            result = joinConstants(term.operation, result, term.operand);
        else if (term.operation == Operation::divide && term.operand.constant)
            result = divideByConstant(result, term);
        else
            result = join(term.operation, result, term.operand);
    }
    return result;
}

FunctionOperand FunctionExpressionParser::divideByConstant(const FunctionOperand& dividend,
                                                           const Term& divisor) {
    if (divisor.operand.value == 0)
        return fail("division-by-zero", divisor.operatorRange, "Division by the constant 0.",
                    "a function may divide by a variable that becomes 0, but not by the number 0");
    const FunctionOperand reciprocal = joinConstants(Operation::divide, constantOperand(1), divisor.operand);
    return join(Operation::multiply, dividend, reciprocal);
}

FunctionOperand FunctionExpressionParser::join(Operation operation, const FunctionOperand& left,
                                               const FunctionOperand& right) {
    WrittenWork& written = scope_.written();
    (operation == Operation::multiply ? written.products
     : operation == Operation::divide ? written.quotients
                                      : written.sums) += 1;
    return {scope_.graph().binary(operation, left.node, right.node)};
}

FunctionOperand FunctionExpressionParser::joinConstants(Operation operation, const FunctionOperand& left,
                                                        const FunctionOperand& right) {
    const double value = combineConstants(operation, left.value, right.value);
    const FunctionGraph& graph = scope_.graph();
    if (graph.isConstant(left.node) && graph.isConstant(right.node)) return constantOperand(value);
    // A declared number that a slider moves: the operation has to stay.
    return {scope_.graph().binary(operation, left.node, right.node), true, value};
}

FunctionOperand FunctionExpressionParser::constantOperand(double value) {
    // A zero enters the function as +0 even where combining gave -0; `value` keeps the sign for further
    // combining.
    return {scope_.graph().constant(value == 0 ? 0.0 : value), true, value};
}

FunctionOperand FunctionExpressionParser::parseSigned() {
    const Token& sign = tokens_.peek();
    if (!sign.is("-") && !sign.is("+")) return parseOperand();
    const bool negative = tokens_.next().is("-");
    if (tokens_.peek().is("-") || tokens_.peek().is("+"))
        return fail("two-signs", tokens_.peek().range, "Only one sign may stand before an operand.",
                    "put the second sign with its operand in parentheses");
    FunctionOperand operand = parseOperand();
    if (!negative || failed_) return operand;
    const bool literal = operand.literal;
    if (operand.constant && scope_.graph().isConstant(operand.node)) {
        operand = constantOperand(-operand.value);
    } else {
        if (!operand.constant) scope_.written().sums += 1;
        operand.node = scope_.graph().unary(Operation::negate, operand.node);
        operand.value = -operand.value;
    }
    operand.literal = literal;
    return operand;
}

FunctionOperand FunctionExpressionParser::parseOperand() {
    if (failed_) return {scope_.graph().constant(0)};
    const Token& token = tokens_.peek();
    if (token.kind == TokenKind::number) {
        FunctionOperand operand = constantOperand(tokens_.next().number);
        operand.literal = true;
        return operand;
    }
    if (token.kind == TokenKind::word) return parseWord();
    if (!token.is("(")) return failExpected("a number, a name, a call or `(`");
    tokens_.next();
    const FunctionOperand inner = parse(combining_);
    if (failed_) return inner;
    if (!tokens_.accept(")")) return failExpected("an operator or `)`");
    return {inner.node};
}

FunctionOperand FunctionExpressionParser::parseWord() {
    const Token word = tokens_.next();
    const Word* known = findWord(word.text);
    if (known && known->is(WordUse::elementaryFunction))
        return FunctionCallParser(*this).parseElementary(word, combining_);
    if (const std::optional<NodeId> node = scope_.find(word.text)) return {*node};
    if (const Value* value = context().symbols.find(word.text)) return parseDeclared(word, *value);
    if (known && known->is(WordUse::functionConstant))
        if (const std::optional<Operand> constant = namedConstant(word.text, context()))
            return constantOperand(constant->value());
    if (const Builtin* builtin = findBuiltin(word.text); builtin && tokens_.peek().is("("))
        return FunctionCallParser(*this).parseUndeclaredBuiltin(word, *builtin, combining_);
    return failUnknown(word);
}

FunctionOperand FunctionExpressionParser::parseDeclared(const Token& name, const Value& value) {
    if (const auto* number = std::get_if<NumberValue>(&value.data)) return declaredNumber(*number);
    if (const auto* function = std::get_if<FunctionValue>(&value.data))
        return FunctionCallParser(*this).parseCall(name, FunctionValue(*function), combining_);
    if (const auto* array = std::get_if<std::shared_ptr<ArrayValue>>(&value.data); array && *array)
        return parseElement(name, *std::shared_ptr<ArrayValue>(*array));
    return fail(
        "not-a-number", name.range,
        "`" + std::string(name.text) + "` is " + kindOf(value) + "; a function can use declared floats only.",
        "declare the component as a float of its own");
}

FunctionOperand FunctionExpressionParser::declaredNumber(const NumberValue& number) {
    const auto& parameters = context().parameters;
    FunctionOperand operand = constantOperand(number.value);
    if (number.parameter >= 0 && static_cast<std::size_t>(number.parameter) < parameters.size()) {
        const int slot = parameters[static_cast<std::size_t>(number.parameter)].slot;
        if (slot >= 0) operand.node = scope_.graph().parameter(slot);
    }
    return operand;
}

FunctionOperand FunctionExpressionParser::parseElement(const Token& name, const ArrayValue& array) {
    std::size_t index = 0;
    for (const int dimension : array.dimensions) {
        if (!tokens_.accept("["))
            return failExpected("`[` and an index of the array `" + std::string(name.text) + "`");
        const double position = ExpressionParser(tokens_).parseFloat();
        if (!(position > -1 && position < dimension))
            return fail("bad-index", tokens_.lastRange(),
                        "The index is outside the array `" + std::string(name.text) +
                            "`, whose elements are 0 to " + std::to_string(dimension - 1) + ".");
        index = index * static_cast<std::size_t>(dimension) + static_cast<std::size_t>(position);
        if (!tokens_.accept("]")) return failExpected("`]`");
    }
    const auto* number =
        index < array.elements.size() ? std::get_if<NumberValue>(&array.elements[index].data) : nullptr;
    if (!number)
        return fail("not-a-number", name.range,
                    "This element of `" + std::string(name.text) + "` is not a float.");
    return constantOperand(number->value);
}

FunctionOperand FunctionExpressionParser::failUnknown(const Token& name) {
    const std::string text(name.text);
    if (const std::string reason = refusedWordReason(name.text); !reason.empty())
        return fail("refused-word", name.range, "`" + text + "` cannot stand in a function.", reason);
    const bool isCall = tokens_.peek().is("(");
    const std::string message =
        "`" + text + "` is not declared" + (isCall ? ": there is no function of that name." : ".");
    if (!failed_)
        reportUnknownWord(context(), "unknown-name", name, message, "function", [this] {
            std::vector<std::string> candidates = context().symbols.names();
            for (const std::string& known : scope_.names()) candidates.push_back(known);
            for (const Word& word : words())
                if (word.is(WordUse::elementaryFunction)) candidates.emplace_back(word.text);
            for (const Builtin& builtin : builtins()) candidates.push_back(builtin.name);
            return candidates;
        });
    return failSilently();
}

}  // namespace isoscope
