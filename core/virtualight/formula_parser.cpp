// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/virtualight/formula_parser.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/evaluate/reference_evaluator.h"
#include "core/language/expressions/parameter_collector.h"
#include "core/language/expressions/slider_range.h"

namespace isoscope::virtualight {

namespace {

/// The text shows cos, sin, exp, sqrt and radians; the others are those of POV-Ray.
bool isFunction(const OperationFacts& facts) { return facts.common && !facts.call.empty(); }

std::optional<Operation> findFunction(std::string_view name) {
    for (std::size_t i = 0; i < operationTable.size(); ++i)
        if (isFunction(operationTable[i]) && operationTable[i].word() == name)
            return static_cast<Operation>(i);
    return std::nullopt;
}

/// Exponents up to here are multiplied out.
constexpr double wholePowerLimit = 64;

}  // namespace

bool FormulaParser::usable(double value) { return std::abs(value) <= 1e100; }

std::optional<Function> FormulaParser::parseFormula(bool keepSliders) {
    FunctionGraph graph;
    graph_ = &graph;
    keepSliders_ = keepSliders;
    failed_ = fixedLiterals_ = false;
    const SourceRange first = tokens_.peek().range;
    const Expression result = sum();
    range_ = tokens_.rangeFrom(first);
    graph_ = nullptr;
    addWaitingSliders();
    if (graph.overflowed() && !failed_) {
        tokens_.context().error("too-large", range_, "The expression is too long.");
        failed_ = true;
    }
    if (failed_) return std::nullopt;
    return finish(std::move(graph), {result.node()}, variableCount);
}

std::optional<double> FormulaParser::parseNumber() {
    const std::optional<Function> formula = parseFormula(false);
    if (!formula) return std::nullopt;
    if (const unsigned used = variablesOf(*formula)) {
        tokens_.context().error(
            "unexpected-variable", range_,
            "A number is expected here, but `" + nameOfVariable(used) + "` has no value in this place.");
        return std::nullopt;
    }
    const std::array<double, variableCount> none{};
    const double value = ReferenceEvaluator(*formula).evaluate(none);
    if (usable(value)) return value;
    tokens_.context().error("bad-value", range_, "This number is infinite, undefined or too large.");
    return std::nullopt;
}

Expression FormulaParser::fail(const char* id, const SourceRange& range, std::string message,
                               std::string hint) {
    // What follows the first mistake of an expression is seldom another one.
    if (!failed_) tokens_.context().error(id, range, std::move(message), std::move(hint));
    failed_ = true;
    return constant(0);
}

Expression FormulaParser::sum() {
    const Nesting nesting(tokens_);
    if (!nesting.ok()) {
        failed_ = true;
        return constant(0);
    }
    Expression value = product();
    for (;;) {
        if (tokens_.accept("+"))
            value = value + product();
        else if (tokens_.accept("-"))
            value = value - product();
        else
            return value;
    }
}

Expression FormulaParser::product() {
    Expression value = signed_();
    for (;;) {
        if (tokens_.accept("*"))
            value = value * signed_();
        else if (tokens_.accept("/"))
            value = value / signed_();
        else
            return value;
    }
}

Expression FormulaParser::signed_() {
    bool negative = false;
    for (;;) {
        if (tokens_.accept("-"))
            negative = !negative;
        else if (!tokens_.accept("+"))
            break;
    }
    const Expression value = power();
    return negative ? -value : value;
}

Expression FormulaParser::power() {
    // Written in place of 0.5 in `0.5^2`, -0.5 would mean something else than in the parameter table, and
    // whole exponents are multiplied out: literals of both are constants of the graph.
    const bool isBase = tokens_.peek(1).is("^");
    const bool fixedLiterals = std::exchange(fixedLiterals_, fixedLiterals_ || isBase);
    const Expression base = primary();
    fixedLiterals_ = fixedLiterals;
    if (!tokens_.accept("^")) return base;
    const Nesting nesting(tokens_);
    if (!nesting.ok()) {
        failed_ = true;
        return base;
    }
    fixedLiterals_ = true;
    const Expression exponent = signed_();
    fixedLiterals_ = fixedLiterals;
    if (failed_ || !graph_->isConstant(exponent.node())) return pow(base, exponent);
    const double value = graph_->value(exponent.node());
    if (value != std::floor(value) || std::abs(value) > wholePowerLimit) return pow(base, exponent);
    const int whole = static_cast<int>(value);
    if (whole == 0) return constant(1);
    return whole > 0 ? powi(base, whole) : 1.0 / powi(base, -whole);
}

Expression FormulaParser::primary() {
    const Token token = tokens_.peek();
    if (token.kind == TokenKind::number) {
        tokens_.next();
        return literal(token);
    }
    if (tokens_.accept("(")) {
        const Expression inner = sum();
        if (!failed_ && !tokens_.expect(")", "to close the parenthesis")) failed_ = true;
        return inner;
    }
    if (token.kind == TokenKind::word) {
        tokens_.next();
        return word(token);
    }
    return fail("unexpected-token", token.range,
                "Expected a number here, but found " + described(token) + ".");
}

Expression FormulaParser::literal(const Token& token) {
    if (!keepSliders_) {
        waiting_.push_back(token);
        return constant(token.number);
    }
    const int slot = addSlider(token, !fixedLiterals_);
    return slot >= 0 ? Expression{*graph_, graph_->parameter(slot)} : constant(token.number);
}

int FormulaParser::addSlider(const Token& token, bool withSlot) {
    ParseContext& context = tokens_.context();
    const auto index = static_cast<int>(context.parameters.size());
    // The declared expression of a primitive is read once, and so is each literal.
    if (token.range.file != 0 || !usable(token.number) ||
        !context.parameterAt.try_emplace(token.range.begin, index).second)
        return -1;
    SceneParameter parameter;
    parameter.name = what_ + ", number " + std::to_string(++literals_);
    parameter.group = group_;
    parameter.statement = context.statement;
    parameter.value = token.number;
    const SliderRange slider = symmetricRangeAround(token.number);
    parameter.minimum = slider.minimum;
    parameter.maximum = slider.maximum;
    parameter.range = token.range;
    context.addParameter(std::move(parameter));
    if (!withSlot) context.markStructural(index);
    return withSlot ? context.parameters.back().slot : -1;
}

void FormulaParser::addWaitingSliders() {
    const bool alone = waiting_.size() == 1 && literalValue(tokens_.context().sources.slice(range_));
    if (!alone)
        for (const Token& token : waiting_) addSlider(token, false);
    waiting_.clear();
}

Expression FormulaParser::word(const Token& name) {
    static constexpr std::array<std::pair<std::string_view, unsigned>, 7> variables{{{"x", variableX},
                                                                                     {"y", variableY},
                                                                                     {"z", variableZ},
                                                                                     {"u", variableU},
                                                                                     {"v", variableV},
                                                                                     {"theta", variableU},
                                                                                     {"phi", variableV}}};
    if (tokens_.peek().is("(")) return call(name);
    // The text's own names come first.
    if (const DeclaredThing* thing = names_.find(name.text)) return declared(name, *thing);
    for (const auto& [word, index] : variables)
        if (name.is(word)) return variable(index);
    if (name.is("CurrentFrame")) return constant(tokens_.context().options.frameNumber);
    if (name.is("Po")) return pointOfIntersection(name);
    const std::string close = names_.closest(name.text);
    return fail("unknown-name", name.range, "`" + std::string(name.text) + "` has no value.",
                close.empty() ? "" : "did you mean `" + close + "`?");
}

Expression FormulaParser::pointOfIntersection(const Token& name) {
    static constexpr std::array<std::pair<const char*, unsigned>, 3> parts{
        {{"x", pointX}, {"y", pointY}, {"z", pointZ}}};
    if (tokens_.accept("."))
        for (const auto& [axis, index] : parts)
            if (tokens_.accept(axis)) return variable(index);
    return fail("unexpected-token", name.range, "`Po` is a point, not a number.",
                "write `Po.x`, `Po.y` or `Po.z`");
}

Expression FormulaParser::declared(const Token& name, const DeclaredThing& thing) {
    if (const auto* number = std::get_if<DeclaredNumber>(&thing)) {
        ParseContext& context = tokens_.context();
        const bool slider = number->parameter >= 0;
        const int slot = slider ? context.parameters[static_cast<std::size_t>(number->parameter)].slot : -1;
        if (keepSliders_ && slot >= 0) return {*graph_, graph_->parameter(slot)};
        context.markStructural(number->parameter);
        return constant(number->value);
    }
    if (const auto* formula = std::get_if<Function>(&thing)) {
        ParseContext& context = tokens_.context();
        context.functionCopies += formula->graph->size();
        if (context.functionCopies > copyLimit)
            tokens_.cut("too-large", name.range,
                        "Reading stops here: the declared expressions are used too often.");
        std::array<NodeId, variableCount> arguments{};
        for (std::size_t k = 0; k < arguments.size(); ++k)
            arguments[k] = graph_->variable(static_cast<int>(k));
        return {*graph_, graph_->inlineCall(*formula, arguments)};
    }
    return fail("not-a-number", name.range, "`" + std::string(name.text) + "` is no number.");
}

Expression FormulaParser::call(const Token& name) {
    tokens_.next();
    const std::optional<Operation> known = findFunction(name.text);
    const bool angle = name.is("radians") || name.is("degrees");
    if (!known && !angle) {
        std::vector<std::string> words{"radians", "degrees"};
        for (const OperationFacts& facts : operationTable)
            if (isFunction(facts)) words.emplace_back(facts.word());
        const std::string close = closestName(name.text, words);
        return fail("unknown-function", name.range, "There is no function `" + std::string(name.text) + "`.",
                    close.empty() ? "" : "did you mean `" + close + "`?");
    }
    const Expression first = sum();
    Expression second = first;
    const bool two = known && arity(*known) == 2;
    if (two && !failed_) {
        if (!tokens_.expect(",", "between the arguments of `" + std::string(name.text) + "`")) failed_ = true;
        second = sum();
    }
    if (!failed_ && !tokens_.expect(")", "to close the arguments of `" + std::string(name.text) + "`"))
        failed_ = true;
    if (name.is("radians")) return first * (std::numbers::pi / 180);
    if (name.is("degrees")) return first * (180 / std::numbers::pi);
    return two ? apply(*known, first, second) : apply(*known, first);
}

unsigned variablesOf(const Function& function) {
    const FunctionGraph& graph = *function.graph;
    std::vector<bool> used(graph.size(), false);
    used[function.results[0]] = true;
    unsigned bits = 0;
    for (NodeId id = function.results[0] + 1; id-- > 0;) {
        if (!used[id]) continue;
        if (graph[id].operation == Operation::variable) bits |= 1u << graph[id].index;
        for (const NodeId operand : graph.operandsOf(id)) used[operand] = true;
    }
    return bits;
}

std::string nameOfVariable(unsigned bits) {
    static constexpr std::array<const char*, variableCount> words{"x", "y",    "z",    "u",
                                                                  "v", "Po.x", "Po.y", "Po.z"};
    for (std::size_t k = 0; k < words.size(); ++k)
        if (bits & (1u << k)) return words[k];
    return {};
}

Function withArguments(const Function& function, std::initializer_list<unsigned> chosen, int argumentCount) {
    FunctionGraph graph;
    std::array<NodeId, variableCount> arguments{};
    for (NodeId& argument : arguments) argument = graph.constant(0);
    int k = 0;
    for (const unsigned variable : chosen) arguments[variable] = graph.variable(k++);
    const NodeId result = graph.inlineCall(function, arguments);
    return finish(std::move(graph), {result}, argumentCount);
}

}  // namespace isoscope::virtualight
