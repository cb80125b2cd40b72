// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/functions/function_parser.h"

#include <cmath>
#include <map>
#include <mutex>

#include "core/language/expressions/expression_parser.h"
#include "core/language/functions/function_words.h"
#include "core/language/objects/spline_parser.h"
#include "core/language/objects/transform_parser.h"
#include "core/language/textures/pattern_parser.h"
#include "core/language/tokens/povray_refusals.h"
#include "core/language/tokens/unknown_name.h"

namespace isoscope {

namespace {

constexpr std::size_t parameterLimit = 56;
/// Operations that all declared functions of one text may hold: some 200 MB.
constexpr std::size_t nodeBudget = 2'000'000;

}  // namespace

FunctionValue builtinFunction(const Builtin& builtin, int noiseGenerator) {
    static std::mutex mutex;
    static std::map<std::pair<const Builtin*, int>, FunctionValue> built;
    const std::lock_guard lock(mutex);
    const auto [entry, isNew] = built.try_emplace({&builtin, noiseGenerator});
    if (!isNew) return entry->second;
    FunctionGraph graph;
    std::vector<Expression> arguments;
    for (int k = 0; k < builtin.argumentCount(); ++k) arguments.emplace_back(graph, graph.variable(k));
    const NodeId result = buildBuiltin(builtin, arguments, noiseGenerator).node();
    std::vector<NodeId> results{result};
    if (builtin.name == "f_hexagon") results = {result, result, result, graph.constant(0), graph.constant(0)};
    FunctionValue& value = entry->second;
    value.function = finish(std::move(graph), std::move(results), builtin.argumentCount());
    value.name = builtin.name;
    if (builtin.pointArguments == 3) value.parameterNames = {"x", "y", "z"};
    for (const BuiltinParameter& parameter : builtin.parameters)
        value.parameterNames.push_back(parameter.name);
    return value;
}

FunctionValue FunctionParser::parse() {
    std::vector<std::string> names;
    startRange_ = tokens_.lastRange();
    const bool understood = parseParameterList(names);
    if (!tokens_.expect("{", "to begin the body of the function")) {
        FunctionValue value;
        value.parameterNames = names;
        return value;
    }
    FunctionValue value;
    if (understood) {
        value = parseBody(std::move(names));
    } else {
        const std::uint32_t begin = tokens_.lastRange().end;
        endBody(true, begin, false);
    }
    return value;
}

bool FunctionParser::parseParameterList(std::vector<std::string>& names) {
    if (!tokens_.accept("(")) return true;
    bool understood = true;
    // POV-Ray forgives missing commas, but none behind the last.
    do {
        const Token name = tokens_.peek();
        if (name.kind != TokenKind::word) {
            context().error("unexpected-token", name.range, "Expected the name of a parameter here.");
            understood = false;
            break;
        }
        tokens_.next();
        understood &= acceptableParameter(name);
        names.emplace_back(name.text);
    } while (tokens_.accept(",") || tokens_.peek().kind == TokenKind::word);
    if (understood && names.size() > parameterLimit) {
        context().error("too-many-parameters", tokens_.lastRange(),
                        "A function has at most " + std::to_string(parameterLimit) + " parameters.");
        understood = false;
    }
    if (!understood)
        while (!tokens_.peek().is(")") && !tokens_.peek().is("{") && tokens_.peek().kind != TokenKind::end)
            tokens_.next();
    return tokens_.expect(")", "to close the list of parameters") && understood;
}

bool FunctionParser::acceptableParameter(const Token& name) {
    const std::string text(name.text);
    if (!mayNameVariable(name.text)) {
        context().error("keyword-as-name", name.range,
                        "`" + text + "` is a word of the language; a parameter needs another name.");
        return false;
    }
    if (const Value* declared = context().symbols.find(name.text)) {
        context().error("name-in-use", name.range,
                        "`" + text + "` is declared already, as " + kindOf(*declared) +
                            "; a parameter needs a new name.");
        return false;
    }
    return true;
}

FunctionValue FunctionParser::parseFormula() {
    FunctionValue value = parse();
    if (form_ && !failed_)
        warnOfRefusal(context(), form_->range,
                      "takes `" + std::string(form_->text) + "` in declared functions alone.",
                      "declare the function, `#declare F = function { ... }`, and call it, `F(x, y, z)`");
    return value;
}

FunctionValue FunctionParser::parseBody(std::vector<std::string> parameterNames, bool untilEnd) {
    const SourceRange opening = tokens_.lastRange();
    const std::uint32_t begin = untilEnd ? 0 : opening.end;
    bodyRange_ = untilEnd ? SourceRange{} : opening;
    failed_ = false;
    form_.reset();
    FunctionValue value;
    value.parameterNames = parameterNames.empty() ? std::vector<std::string>{"x", "y", "z"} : parameterNames;
    const Token first = tokens_.peek();
    const std::string word(first.kind == TokenKind::word ? first.text : std::string_view());
    const bool isForm = word == "internal" || word == "pattern" || word == "pigment" || word == "spline" ||
                        word == "transform";
    if (isForm && !parameterNames.empty()) {
        context().error("unexpected-parameters", first.range,
                        "A function made of `" + word + "` takes no list of parameters.");
        failed_ = true;
    } else if (isForm) {
        form_ = tokens_.next();
        parseForm(word, value);
    } else {
        FunctionScope scope(std::move(parameterNames));
        parseExpression(scope, value, untilEnd);
    }
    endBody(failed_, begin, untilEnd);
    if (failed_) value.function = {nullptr, {}, static_cast<int>(value.parameterNames.size())};
    return value;
}

void FunctionParser::parseExpression(FunctionScope& scope, FunctionValue& value, bool untilEnd) {
    FunctionExpressionParser expressions(tokens_, scope);
    const FunctionOperand result = expressions.parse();
    const auto ends = [&] {
        const Token& next = tokens_.peek();
        // Where the text ends inside the braces, endBody() tells it.
        return next.kind == TokenKind::end ||
               (!untilEnd && (next.is("}") || closeUnclosed(tokens_, "function")));
    };
    if (!expressions.failed() && !ends())
        expressions.failExpected(untilEnd ? "an operator or the end of the function"
                                          : "an operator or `}` to close the function");
    failed_ = expressions.failed();
    if (failed_) return;
    keep(scope, {result.node}, value);
    value.written = std::make_shared<const WrittenWork>(std::move(scope.written()));
}

void FunctionParser::keep(FunctionScope& scope, std::vector<NodeId> results, FunctionValue& value) {
    context().functionNodes += scope.nodeCount();
    if (scope.overflowed()) {
        context().error(
            "too-large", startRange_,
            "The function holds more than " + std::to_string(FunctionGraph::nodeLimit) + " operations.",
            "calls of calls multiply; declare the function with fewer of them");
        failed_ = true;
    } else if (context().functionNodes > nodeBudget) {
        context().error(
            "too-large", startRange_,
            "The functions of this text hold more than " + std::to_string(nodeBudget) + " operations.");
        failed_ = true;
    } else {
        value.function = scope.finish(std::move(results));
    }
}

bool FunctionParser::parseForm(const std::string& word, FunctionValue& value) {
    if (word == "internal")
        parseInternal(value);
    else if (word == "pattern")
        parsePattern(value);
    else if (word == "transform")
        parseTransform(value);
    else if (word == "spline")
        parseSpline(value);
    else if (word == "pigment")
        parsePigment(value);
    return !failed_;
}

void FunctionParser::parseInternal(FunctionValue& value) {
    const auto fail = [&](const SourceRange& range, const std::string& message) {
        if (!failed_) context().error("unknown-internal", range, message);
        failed_ = true;
    };
    if (!tokens_.accept("("))
        return fail(tokens_.peek().range, "Expected `(` and the number of a built-in function.");
    const Token number = tokens_.next();
    const Builtin* builtin = nullptr;
    if (number.kind == TokenKind::number && number.number == std::floor(number.number) &&
        number.number >= 0 && number.number <= 1e6)
        builtin = findBuiltin(static_cast<int>(number.number));
    else if (number.kind == TokenKind::word && number.range.file != 0)
        builtin =
            findBuiltin(number.text);  // how the program's own functions.inc names those without a number
    else
        fail(number.range, "Expected the number of a built-in function, 0 to 78.");
    if (!failed_ && !builtin)
        fail(number.range,
             "There is no built-in function number " + std::string(number.text) + "; they are 0 to 78.");
    if (!failed_ && !tokens_.accept(")")) fail(tokens_.peek().range, "Expected `)` behind the number.");
    if (!failed_) value = builtinFunction(*builtin, context().noiseGenerator);
}

void FunctionParser::parsePattern(FunctionValue& value) {
    FunctionScope scope({});
    const std::optional<NodeId> result = PatternParser(tokens_, scope).parse();
    failed_ = !result;
    if (result) keep(scope, {*result}, value);
}

void FunctionParser::parsePigment(FunctionValue& value) {
    FunctionScope scope({});
    std::vector<NodeId> results = PatternParser(tokens_, scope).parsePigment();
    failed_ = results.empty();
    if (!failed_) keep(scope, std::move(results), value);
}

void FunctionParser::parseTransform(FunctionValue& value) {
    if (!tokens_.expect("{", "to begin the transform")) {
        failed_ = true;
        return;
    }
    const Transform transform = TransformParser(tokens_).parseBlock();
    FunctionScope scope({});
    const glm::dmat4& m = transform.forward();
    const Expression x = scope.expression(*scope.find("x")), y = scope.expression(*scope.find("y")),
                     z = scope.expression(*scope.find("z"));
    std::vector<NodeId> results;
    for (int row = 0; row < 3; ++row)
        results.push_back((x * m[0][row] + y * m[1][row] + z * m[2][row] + m[3][row]).node());
    keep(scope, std::move(results), value);
}

void FunctionParser::parseSpline(FunctionValue& value) {
    value.parameterNames = {"x"};
    const std::shared_ptr<const Spline> spline = SplineParser(tokens_).parse();
    failed_ = !spline;
    if (!spline) return;
    FunctionScope scope({"x"});
    keep(scope, spline->build(scope.graph(), *scope.find("x")), value);
}

void FunctionParser::endBody(bool failed, std::uint32_t begin, bool untilEnd) {
    if (untilEnd) {
        if (!failed && tokens_.peek().kind != TokenKind::end) {
            context().error("unexpected-token", tokens_.peek().range,
                            "Expected the end of the function here.");
            failed_ = true;
        }
        while (tokens_.next().kind != TokenKind::end) continue;
        bodyRange_ = {tokens_.lastRange().file, begin, tokens_.lastRange().end};
        return;
    }
    if (failed)
        tokens_.skipBlock();
    else if (!tokens_.expect("}", "to close the function"))
        failed_ = tokens_.peek().kind != TokenKind::end || tokens_.cutOff();
    const SourceRange& last = tokens_.lastRange();
    if (last.file == bodyRange_.file && last.begin >= begin)
        bodyRange_ = {last.file, begin, context().sources.slice(last) == "}" ? last.begin : last.end};
    else
        bodyRange_ = {};
}

}  // namespace isoscope
