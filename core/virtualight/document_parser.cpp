// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/virtualight/document_parser.h"

#include <algorithm>
#include <limits>

#include "core/language/directives/statement_scope.h"
#include "core/language/expressions/parameter_collector.h"
#include "core/language/expressions/slider_range.h"
#include "core/language/objects/object_description.h"
#include "core/language/scene_draft.h"

namespace isoscope::virtualight {

namespace {

/// The panel knows declared numbers of both notations by this.
const std::string declarations = "#declare";

bool beginsShape(const Token& token) { return token.is("Shape") || token.is("Solid"); }

}  // namespace

DocumentParser::DocumentParser(ParseContext& context, std::uint32_t file)
    : context_(context), tokens_(context, file) {}

Document DocumentParser::parse() {
    while (tokens_.peek().kind != TokenKind::end) parseStatement();
    return std::move(document_);
}

void DocumentParser::parseStatement() {
    const Token token = tokens_.peek();
    if (tokens_.accept(";")) return;
    if (tokens_.accept("static")) return parseStatic();
    if (tokens_.accept("Declare")) return parseDeclare();
    const DeclaredThing* thing = token.kind == TokenKind::word ? names_.find(token.text) : nullptr;
    const bool isNode = thing && std::holds_alternative<NodePointer>(*thing);
    if (beginsShape(token) || isNode) {
        if (const NodePointer node = parseObject()) document_.shown.push_back(node);
        return;
    }
    if (PrimitiveParser::isPrimitive(token.text)) {
        context_.error("unexpected-token", token.range,
                       "`" + std::string(token.text) + "` must stand in a Shape.",
                       "write `Shape [ " + std::string(token.text) + "(...) ]`");
        tokens_.skipItem();
        return;
    }
    if (atOther()) {
        skipOther();
        return;
    }
    context_.error("unknown-statement", token.range,
                   "Expected `Shape`, `Solid`, `Declare` or `static`, but found " + described(token) + ".");
    tokens_.next();
    tokens_.skipTo(0);
}

bool DocumentParser::atOther() {
    if (tokens_.peek().kind != TokenKind::word) return false;
    const Token& behind = tokens_.peek(1);
    if (behind.is("[") || behind.is("(")) return true;
    // The constants of the archive file are known without it.
    const std::string_view word = tokens_.peek().text;
    return (word == "include" || word == "Include") && behind.kind == TokenKind::string;
}

std::string DocumentParser::skipOther() {
    const Token word = tokens_.next();
    if (tokens_.peek().kind == TokenKind::string)
        tokens_.next();
    else
        tokens_.skipItem();
    const std::string meant = closestName(word.text, {"Shape", "Solid", "Declare", "static"});
    context_.report({Severity::leftOut,
                     "left-out",
                     tokens_.rangeFrom(word.range),
                     "`" + std::string(word.text) + "` is not simulated.",
                     word.is("include") || word.is("Include")
                         ? "the constants of statics.vib are known without it; put other declarations here"
                     : meant.empty() ? "only shapes, solids, transformations and shape modifiers are drawn"
                                     : "did you mean `" + meant + "`?",
                     {}});
    return std::string(word.text);
}

void DocumentParser::parseStatic() {
    const Token name = tokens_.peek();
    if (name.kind != TokenKind::word) {
        context_.error("unexpected-token", name.range,
                       "Expected a name behind `static`, but found " + described(name) + ".");
        return;
    }
    tokens_.next();
    if (!tokens_.expect("=", "behind the name in `static`")) return;
    FormulaParser parser(tokens_, names_, declarations, std::string(name.text));
    if (const std::optional<double> value = parser.parseNumber())
        names_.declare(std::string(name.text), numberWithSlider(name, *value, parser.range()));
}

DeclaredNumber DocumentParser::numberWithSlider(const Token& name, double value, const SourceRange& range) {
    const std::string text(context_.sources.slice(range));
    if (range.file != 0 || !literalValue(text)) return {value, -1};
    SceneParameter parameter;
    parameter.role = ParameterRole::declared;
    parameter.name = std::string(name.text);
    parameter.group = declarations;
    parameter.value = value;
    const SliderRange slider = sliderRangeAround(value);
    parameter.minimum = slider.minimum;
    parameter.maximum = slider.maximum;
    parameter.range = range;
    parameter.text = text;
    return {value, context_.addParameter(std::move(parameter))};
}

void DocumentParser::parseDeclare() {
    const Token name = tokens_.peek();
    if (name.kind != TokenKind::word) {
        context_.error("unexpected-token", name.range,
                       "Expected a name behind `Declare`, but found " + described(name) + ".");
        return;
    }
    tokens_.next();
    if (!tokens_.expect("=", "behind the name in `Declare`")) return;
    if (std::optional<DeclaredThing> thing = parseDeclared(name)) {
        names_.declare(std::string(name.text), std::move(*thing));
    } else {
        // That has been said; using the name is no second mistake.
        names_.declare(std::string(name.text), DeclaredOther{""});
        tokens_.skipTo(0);
    }
}

std::optional<DeclaredThing> DocumentParser::parseDeclared(const Token& name) {
    const Token token = tokens_.peek();
    if (beginsShape(token)) {
        const NodePointer node = parseObject();
        if (!node) return std::nullopt;
        Node named = *node;
        named.name = std::string(name.text);
        document_.declared.push_back(std::make_shared<const Node>(std::move(named)));
        return document_.declared.back();
    }
    if (PrimitiveParser::isPrimitive(token.text) && tokens_.peek(1).is("(")) {
        std::optional<ParsedPrimitive> parsed = PrimitiveParser::parse(tokens_, names_);
        if (!parsed) return std::nullopt;
        Node node;
        node.primitive = std::move(parsed->primitive);
        node.functionRange = parsed->functionRange;
        node.keyword = std::string(token.text);
        node.range = tokens_.rangeFrom(token.range);
        return finished(std::move(node));
    }
    if (token.kind == TokenKind::word) {
        const DeclaredThing* thing = names_.find(token.text);
        const bool simple = thing && !std::holds_alternative<DeclaredNumber>(*thing) &&
                            !std::holds_alternative<Function>(*thing);
        if (simple) {
            tokens_.next();
            return *thing;
        }
        if (tokens_.peek(1).is("[")) return DeclaredOther{skipOther()};
    }
    std::optional<DeclaredThing> value = parsePointOrFormula(name);
    if (auto* number = value ? std::get_if<DeclaredNumber>(&*value) : nullptr)
        *number = numberWithSlider(name, number->value, tokens_.rangeFrom(token.range));
    return value;
}

std::optional<DeclaredThing> DocumentParser::parsePointOrFormula(const Token& name) {
    // `(a, b, c)` is told from `(a + b) * c` by the comma in the outermost parentheses.
    std::size_t depth = 0, commas = 0;
    for (std::size_t ahead = 0; tokens_.peek().is("("); ++ahead) {
        constexpr std::size_t lookAhead = 1000;
        const Token& token = tokens_.peek(ahead);
        if (token.is("(")) ++depth;
        if (token.is(")") && --depth == 0) break;
        if (token.is(",") && depth == 1) ++commas;
        if (token.kind == TokenKind::end || ahead > lookAhead) break;
    }
    if (commas == 2) {
        ArgumentReader point(tokens_, names_, name);
        const double x = point.number("x"), y = point.number("y"), z = point.number("z");
        point.close();
        if (point.failed()) return std::nullopt;
        return glm::dvec3(x, y, z);
    }
    FormulaParser parser(tokens_, names_, declarations, std::string(name.text));
    std::optional<Function> formula = parser.parseFormula(false);
    if (!formula) return std::nullopt;
    if (variablesOf(*formula) != 0) return std::move(*formula);
    const double value = formula->graph->isConstant(formula->results[0])
                             ? formula->graph->value(formula->results[0])
                             : std::numeric_limits<double>::quiet_NaN();
    if (FormulaParser::usable(value)) return DeclaredNumber{value, -1};
    context_.error("bad-value", parser.range(), "This number is infinite, undefined or too large.");
    return std::nullopt;
}

NodePointer DocumentParser::finished(Node node) {
    for (const NodePointer& part : node.parts) {
        node.depth = std::max(node.depth, part->depth + 1);
    }
    if (!node.parts.empty()) node.shapeCount = 0;
    for (const NodePointer& part : node.parts) node.shapeCount += part->shapeCount;
    if (node.shapeCount > ObjectDescription::shapeLimit || node.depth > ObjectDescription::depthLimit / 2) {
        context_.error("too-large", node.range,
                       "This solid has more than " + std::to_string(ObjectDescription::shapeLimit) +
                           " parts, or is nested more than " +
                           std::to_string(ObjectDescription::depthLimit / 2) + " deep.");
        return nullptr;
    }
    return std::make_shared<const Node>(std::move(node));
}

NodePointer DocumentParser::parseObject() {
    const Nesting nesting(tokens_);
    if (!nesting.ok()) return nullptr;
    const StatementScope scope(context_);
    if (tokens_.peek().is("Shape")) return parseShape();
    if (tokens_.peek().is("Solid")) return parseSolid();
    return parseNamed();
}

NodePointer DocumentParser::parseNamed() {
    const Token name = tokens_.next();
    const DeclaredThing* thing = name.kind == TokenKind::word ? names_.find(name.text) : nullptr;
    if (const auto* node = thing ? std::get_if<NodePointer>(thing) : nullptr) return *node;
    if (thing && std::holds_alternative<DeclaredOther>(*thing)) return nullptr;
    if (thing)
        context_.error("not-an-object", name.range, "`" + std::string(name.text) + "` is no shape.");
    else if (name.kind == TokenKind::word)
        context_.error(
            "unknown-name", name.range, "`" + std::string(name.text) + "` is not declared.",
            names_.closest(name.text).empty() ? "" : "did you mean `" + names_.closest(name.text) + "`?");
    else
        context_.error("unexpected-token", name.range,
                       "Expected a Shape, a Solid or the name of one, but found " + described(name) + ".");
    return nullptr;
}

void DocumentParser::closeStructure(const Token& word, std::size_t depth) {
    if (!tokens_.expect("]", "to close `" + std::string(word.text) + "`")) tokens_.skipTo(depth);
}

NodePointer DocumentParser::parseShape() {
    const Token word = tokens_.next();
    const std::size_t depth = tokens_.depth();
    if (!tokens_.expect("[", "to begin `Shape`")) return nullptr;
    Node node;
    node.keyword = "Shape";
    const bool drawn = parseContents(node);
    parseModifiers(node);
    closeStructure(word, depth);
    node.range = tokens_.rangeFrom(word.range);
    return drawn ? finished(std::move(node)) : nullptr;
}

bool DocumentParser::parseContents(Node& node) {
    const Token token = tokens_.peek();
    if (PrimitiveParser::isPrimitive(token.text)) {
        std::optional<ParsedPrimitive> parsed = PrimitiveParser::parse(tokens_, names_);
        if (!parsed) return false;
        node.primitive = std::move(parsed->primitive);
        node.functionRange = parsed->functionRange;
        node.keyword = std::string(token.text);
        return true;
    }
    const DeclaredThing* thing = token.kind == TokenKind::word ? names_.find(token.text) : nullptr;
    if (const auto* declared = thing ? std::get_if<NodePointer>(thing) : nullptr) {
        tokens_.next();
        const Node& inner = **declared;
        const bool bare = inner.primitive && inner.name.empty() && inner.transforms.empty();
        if (bare) {
            // A primitive declared alone is used as if it stood here.
            node.primitive = inner.primitive;
            node.functionRange = inner.functionRange;
            node.keyword = inner.keyword;
        } else {
            node.parts = {*declared};
        }
        return true;
    }
    if (token.is("]") || token.kind == TokenKind::end) {
        context_.error("missing-primitive", token.range, "A Shape begins with a primitive.");
        return false;
    }
    if (thing && std::holds_alternative<DeclaredOther>(*thing)) {
        tokens_.next();
        return false;
    }
    const std::string close = PrimitiveParser::closestName(token.text);
    const std::string hint = close.empty() ? "" : "did you mean `" + close + "`?";
    context_.error("missing-primitive", token.range,
                   "A Shape begins with a primitive, but here is " + described(token) + ".", hint);
    if (token.kind == TokenKind::word) {
        tokens_.next();
        if (tokens_.peek().is("(")) tokens_.skipItem();
    }
    return false;
}

NodePointer DocumentParser::parseSolid() {
    const Token word = tokens_.next();
    const std::size_t depth = tokens_.depth();
    if (!tokens_.expect("[", "to begin `Solid`")) return nullptr;
    const NodePointer contents = parseSums();
    if (!contents) {
        // What is wrong has been said; what follows would only be misunderstood.
        tokens_.skipTo(depth);
        return nullptr;
    }
    Node node;
    node.keyword = "Solid";
    parseModifiers(node);
    closeStructure(word, depth);
    node.range = tokens_.rangeFrom(word.range);
    if (node.modifiers.empty() && node.transforms.empty() && contents->name.empty()) {
        Node plain = *contents;
        plain.range = node.range;
        return std::make_shared<const Node>(std::move(plain));
    }
    node.parts = {contents};
    return finished(std::move(node));
}

NodePointer DocumentParser::joined(SetOperation operation, NodePointer first, NodePointer second,
                                   const SourceRange& start) {
    if (!first || !second) return nullptr;
    Node node;
    node.keyword = "Solid";
    node.operation = operation;
    node.range = tokens_.rangeFrom(start);
    // A + B + C is one union: long rows shall not be deep trees.
    const bool same = !first->primitive && first->operation == operation && first->name.empty() &&
                      first->modifiers.empty() && first->transforms.empty() && first->parts.size() > 1 &&
                      first->range.begin == start.begin && first->keyword == "Solid" &&
                      operation != SetOperation::inverse;
    node.parts = same ? first->parts : std::vector{first};
    node.parts.push_back(std::move(second));
    return finished(std::move(node));
}

NodePointer DocumentParser::parseSums() {
    const Nesting nesting(tokens_);
    if (!nesting.ok()) return nullptr;
    const SourceRange start = tokens_.peek().range;
    NodePointer value = parseProducts();
    for (;;) {
        SetOperation operation = SetOperation::union_;
        if (tokens_.accept("^"))
            operation = SetOperation::merge;
        else if (tokens_.accept("-"))
            operation = SetOperation::difference;
        else if (!tokens_.accept("+"))
            return value;
        value = joined(operation, value, parseProducts(), start);
    }
}

NodePointer DocumentParser::parseProducts() {
    const SourceRange start = tokens_.peek().range;
    NodePointer value = parseFactor();
    for (;;) {
        SetOperation operation = SetOperation::intersection;
        if (tokens_.accept("&"))
            operation = SetOperation::clipping;
        else if (!tokens_.accept("*"))
            return value;
        value = joined(operation, value, parseFactor(), start);
    }
}

NodePointer DocumentParser::parseFactor() {
    const SourceRange start = tokens_.peek().range;
    bool inverse = false;
    while (tokens_.accept("~")) inverse = !inverse;
    NodePointer value;
    if (tokens_.accept("(")) {
        value = parseSums();
        if (value && !tokens_.expect(")", "to close the parenthesis")) value = nullptr;
    } else {
        value = parseObject();
    }
    if (!inverse || !value) return value;
    Node node;
    node.keyword = "Solid";
    node.operation = SetOperation::inverse;
    node.parts = {value};
    node.range = tokens_.rangeFrom(start);
    return finished(std::move(node));
}

}  // namespace isoscope::virtualight
