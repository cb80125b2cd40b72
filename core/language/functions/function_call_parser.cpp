// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/functions/function_call_parser.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "core/image/brightness.h"
#include "core/language/directives/statement_scope.h"
#include "core/language/expressions/parameter_collector.h"

namespace isoscope {

namespace {

/// Operations that all calls of one text may copy; far beyond any surface, and a second or two of work.
constexpr std::size_t copyLimit = 5'000'000;
/// Steps of a sum or prod with constant bounds.
constexpr double loopLimit = 1e6;

std::string quoted(const Token& name) { return "`" + std::string(name.text) + "`"; }

std::string plural(int count, const std::string& noun) {
    return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string takesOf(const Builtin& builtin) {
    const int extra = static_cast<int>(builtin.parameters.size());
    if (builtin.pointArguments == 0) return plural(extra, "argument");
    return extra == 0 ? "x, y and z" : "x, y, z and " + plural(extra, "parameter");
}

std::string takesOf(const FunctionValue& function) {
    std::string names;
    for (const std::string& name : function.parameterNames) names += (names.empty() ? "" : ", ") + name;
    return plural(function.function.argumentCount, "argument") + " (" + names + ")";
}

}  // namespace

std::vector<NodeId> callComponents(FunctionGraph& graph, const Function& function,
                                   std::span<const NodeId> arguments) {
    std::vector<NodeId> components;
    for (std::size_t k = 0; k < function.results.size(); ++k)
        components.push_back(graph.inlineCall(function, arguments, k));
    return components;
}

SourceRange FunctionCallParser::callRange(const Token& name) const {
    SourceRange range = name.range;
    const SourceRange& last = tokens_.lastRange();
    if (last.file == range.file && last.end > range.begin) range.end = last.end;
    return range;
}

FunctionOperand FunctionCallParser::failCount(const Token& name, const std::string& takes, int wanted,
                                              int given) {
    const int difference = std::abs(wanted - given);
    const std::string verdict = std::to_string(difference) + (difference == 1 ? " is " : " are ") +
                                (given < wanted ? "missing." : "too many.");
    return expressions_.fail("argument-count", callRange(name),
                             quoted(name) + " takes " + takes + "; " + verdict);
}

std::vector<FunctionCallParser::Argument> FunctionCallParser::parseArguments(const Token& name,
                                                                             bool combining,
                                                                             bool combineAll) {
    std::vector<Argument> arguments;
    if (!tokens_.accept("(")) {
        expressions_.failExpected("`(` and the arguments of " + quoted(name));
        return arguments;
    }
    if (tokens_.accept(")")) return arguments;
    do {
        Argument argument;
        argument.range = tokens_.peek().range;
        argument.operand = expressions_.parse(combining && (arguments.empty() || combineAll));
        const SourceRange& last = tokens_.lastRange();
        // Where a macro brings in part of an argument, there is no one piece of text to point at.
        argument.range.end = last.file == argument.range.file ? last.end : argument.range.begin;
        arguments.push_back(argument);
    } while (!failed() && tokens_.accept(","));
    if (!failed() && !tokens_.accept(")")) expressions_.failExpected("an operator, `,` or `)`");
    return arguments;
}

FunctionOperand FunctionCallParser::parseElementary(const Token& name, bool combining) {
    const ElementaryFunction& function = *findElementaryFunction(name.text);
    if (function.operation == Operation::sum || function.operation == Operation::product)
        return parseLoop(name, function.operation);
    const bool isPower = function.operation == Operation::power;
    const std::vector<Argument> arguments = parseArguments(name, combining, isPower);
    if (failed()) return {scope_.graph().constant(0)};
    return applyElementary(name, function, arguments);
}

FunctionOperand FunctionCallParser::applyElementary(const Token& name, const ElementaryFunction& function,
                                                    const std::vector<Argument>& arguments) {
    FunctionGraph& graph = scope_.graph();
    const int given = static_cast<int>(arguments.size());
    const auto node = [&](int k) { return arguments[static_cast<std::size_t>(k)].operand.node; };
    if (function.arguments > 0 && given != function.arguments)
        return failCount(name, plural(function.arguments, "argument"), function.arguments, given);
    const bool isFolded =
        function.operation == Operation::minimum || function.operation == Operation::maximum;
    scope_.written().calls[std::string(name.text)] += isFolded ? given - 1 : 1;
    switch (function.operation) {
        case Operation::power:
            if (given < 1 || given > 2) return failCount(name, "2 arguments", 2, given);
            return applyPower(arguments);
        case Operation::minimum:
        case Operation::maximum: {
            if (given < 2) return failCount(name, "at least 2 arguments", 2, given);
            NodeId result = node(0);
            for (int k = 1; k < given; ++k) result = graph.binary(function.operation, result, node(k));
            return {result};
        }
        case Operation::select3:
            if (given == 3) return {graph.ternary(Operation::select3, node(0), node(1), node(2))};
            if (given == 4) return {graph.quaternary(Operation::select4, node(0), node(1), node(2), node(3))};
            return failCount(name, "3 or 4 arguments", given < 3 ? 3 : 4, given);
        case Operation::multiply: {
            const double factor = name.text == "degrees" ? 180 / std::numbers::pi : std::numbers::pi / 180;
            return {graph.binary(Operation::multiply, node(0), graph.constant(factor))};
        }
        default: break;
    }
    if (function.arguments == 1) return {graph.unary(function.operation, node(0))};
    return {graph.binary(function.operation, node(0), node(1))};
}

FunctionOperand FunctionCallParser::applyPower(const std::vector<Argument>& arguments) {
    // With one argument POV-Ray returns it as it is.
    if (arguments.size() == 1) return {arguments[0].operand.node};
    const FunctionOperand& exponent = arguments[1].operand;
    const Expression base = scope_.expression(arguments[0].operand.node);
    const bool whole = exponent.constant && scope_.graph().isConstant(exponent.node) && exponent.value >= 2 &&
                       exponent.value <= 8 && exponent.value == std::floor(exponent.value);
    if (whole) return {powi(base, static_cast<int>(exponent.value)).node()};
    return {pow(base, scope_.expression(exponent.node)).node()};
}

FunctionOperand FunctionCallParser::parseLoop(const Token& name, Operation operation) {
    if (!tokens_.accept("(")) return expressions_.failExpected("`(` and the arguments of " + quoted(name));
    const Token variable = tokens_.peek();
    if (variable.kind != TokenKind::word || !mayNameVariable(variable.text))
        return expressions_.failExpected("the name of the variable that " + quoted(name) + " counts with");
    if (expressions_.context().symbols.find(variable.text))
        return expressions_.fail("name-in-use", variable.range,
                                 "`" + std::string(variable.text) +
                                     "` is declared already; the variable of " + quoted(name) +
                                     " needs a new name.");
    tokens_.next();
    return parseLoopBody(name, operation, variable);
}

FunctionOperand FunctionCallParser::parseLoopBody(const Token& name, Operation operation,
                                                  const Token& variable) {
    const std::string takes = "4 arguments: a variable, its first and last value, and an expression";
    NodeId bounds[2] = {noNode, noNode};
    for (int k = 0; k < 2; ++k) {
        if (!tokens_.accept(",")) {
            if (tokens_.accept(")")) return failCount(name, takes, 4, 1 + k);
            return expressions_.failExpected("an operator or `,`");
        }
        bounds[k] = expressions_.parse(false).node;
        if (failed()) return {bounds[k]};
    }
    if (!tokens_.accept(",")) {
        if (tokens_.accept(")")) return failCount(name, takes, 4, 3);
        return expressions_.failExpected("an operator or `,`");
    }
    WrittenWork written = std::exchange(scope_.written(), {});
    scope_.beginLoop(std::string(variable.text));
    const NodeId result = expressions_.parse(false).node;
    const FunctionScope::LoopBody loop = scope_.endLoop(result);
    FunctionGraph& graph = scope_.graph();
    if (failed()) return {graph.constant(0)};
    if (tokens_.peek().is(",")) return failCount(name, takes, 4, 5);
    if (!tokens_.accept(")")) return expressions_.failExpected("an operator or `)`");
    if (graph.isConstant(bounds[0]) && graph.isConstant(bounds[1]) &&
        graph.value(bounds[1]) - graph.value(bounds[0]) > loopLimit)
        return expressions_.fail("loop-too-long", callRange(name),
                                 quoted(name) + " would take more than a million steps at every point.");
    const bool areKnown = graph.isConstant(bounds[0]) && graph.isConstant(bounds[1]);
    const double steps =
        areKnown ? graph.value(bounds[1]) - graph.value(bounds[0]) + 1 : WrittenWork::unknownSteps;
    scope_.written().sums += 1;
    if (steps > 0) written.add(scope_.written(), steps);
    scope_.written() = std::move(written);
    return {graph.loop(operation, bounds[0], bounds[1], loop.body, loop.captured)};
}

FunctionOperand FunctionCallParser::parseCall(const Token& name, const FunctionValue& function,
                                              bool combining) {
    if (!function.name.empty())
        if (const Builtin* builtin = findBuiltin(function.name))
            return parseBuiltinCall(name, *builtin, combining);
    const std::vector<Argument> arguments = parseArguments(name, combining);
    if (failed()) return {scope_.graph().constant(0)};
    // A function whose own declaration was wrong or left out has been reported there.
    if (!function.function.valid()) return expressions_.failSilently();
    const int wanted = function.function.argumentCount;
    const int given = static_cast<int>(arguments.size());
    if (given != wanted) return failCount(name, takesOf(function), wanted, given);
    ParseContext& context = expressions_.context();
    context.functionCopies += function.function.graph->size() * function.function.results.size();
    if (context.functionCopies > copyLimit)
        return expressions_.fail("too-large", name.range,
                                 "The functions of this text call each other too often.",
                                 "together their calls copy more than 5 million operations");
    WrittenWork& written = scope_.written();
    (function.written ? written.declaredCalls : written.compiledCalls) += 1;
    if (function.written) written.add(*function.written, 1);
    std::vector<NodeId> nodes;
    for (const Argument& argument : arguments) nodes.push_back(argument.operand.node);
    return parseMember(name, callComponents(scope_.graph(), function.function, nodes));
}

FunctionOperand FunctionCallParser::parseUndeclaredBuiltin(const Token& name, const Builtin& builtin,
                                                           bool combining) {
    ParseContext& context = expressions_.context();
    if (!context.builtinsKnown)
        context.warning("missing-include", name.range,
                        quoted(name) + " is a function of functions.inc, which has not been included.",
                        "add #include \"functions.inc\", or POV-Ray will refuse the scene");
    return parseBuiltinCall(name, builtin, combining);
}

NodeId FunctionCallParser::builtinArgument(const Builtin& builtin, int index, const Argument& argument) {
    const int parameter = index - builtin.pointArguments;
    if (parameter < 0 || builtin.pointArguments == 0) return argument.operand.node;
    ParameterCollector collector(expressions_.context());
    if (!argument.operand.literal) {
        collector.addArgumentExpression(builtin, parameter, argument.range);
        return argument.operand.node;
    }
    const int slot = collector.addArgument(builtin, parameter, argument.operand.value, argument.range);
    return slot < 0 ? argument.operand.node : scope_.graph().parameter(slot);
}

FunctionOperand FunctionCallParser::parseBuiltinCall(const Token& name, const Builtin& builtin,
                                                     bool combining) {
    const std::vector<Argument> arguments = parseArguments(name, combining);
    if (failed()) return {scope_.graph().constant(0)};
    const int given = static_cast<int>(arguments.size());
    if (given != builtin.argumentCount())
        return failCount(name, takesOf(builtin), builtin.argumentCount(), given);
    scope_.written().calls[builtin.name] += 1;
    std::vector<Expression> values;
    const StatementScope call(expressions_.context());
    for (int k = 0; k < given; ++k)
        values.push_back(
            scope_.expression(builtinArgument(builtin, k, arguments[static_cast<std::size_t>(k)])));
    const NodeId result = buildBuiltin(builtin, values, expressions_.context().noiseGenerator).node();
    if (builtin.name != "f_hexagon") return {result};
    // The one colour function among them: grey, nothing filtered or transmitted.
    const NodeId zero = scope_.graph().constant(0);
    return parseMember(name, {result, result, result, zero, zero});
}

FunctionOperand FunctionCallParser::parseMember(const Token& name, const std::vector<NodeId>& components) {
    if (components.size() == 1) return {components[0]};
    const std::string kind = components.size() == 3 ? "a vector" : "a colour";
    if (!tokens_.accept("."))
        return expressions_.failExpected("`.` and a component, because " + quoted(name) + " gives " + kind +
                                         ",");
    const Token member = tokens_.peek();
    struct Entry {
        const char* name;
        std::size_t component;
    };
    static constexpr Entry entries[] = {{"x", 0}, {"u", 0},      {"red", 0},     {"y", 1},
                                        {"v", 1}, {"green", 1},  {"z", 2},       {"blue", 2},
                                        {"t", 3}, {"filter", 3}, {"transmit", 4}};
    for (const Entry& entry : entries)
        if (member.is(entry.name) && entry.component < components.size()) {
            tokens_.next();
            return {components[entry.component]};
        }
    const auto part = [&](std::size_t k) { return scope_.expression(components[k]); };
    if ((member.is("gray") || member.is("grey")) && components.size() >= 3) {
        tokens_.next();
        return {brightness(part(0), part(1), part(2)).node()};
    }
    if (member.is("hf") && components.size() >= 2) {
        tokens_.next();
        return {((part(0) + part(1) / 255.0) * 0.996093).node()};
    }
    return expressions_.failExpected("a component such as `x` or `red`");
}

}  // namespace isoscope
