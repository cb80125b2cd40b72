// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/pattern_parser.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>

#include "core/language/color_ramp_parser.h"
#include "core/language/expression_parser.h"
#include "core/language/function_parser.h"
#include "core/language/nesting_guard.h"
#include "core/language/object_pattern.h"
#include "core/language/transform_parser.h"
#include "core/language/warp_parser.h"

namespace isoscope {

namespace {

const std::map<std::string_view, PatternKind> kinds{
    {"agate", PatternKind::agate},     {"boxed", PatternKind::boxed},
    {"bozo", PatternKind::bozo},       {"brick", PatternKind::brick},
    {"bumps", PatternKind::bumps},     {"cells", PatternKind::cells},
    {"checker", PatternKind::checker}, {"crackle", PatternKind::crackle},
    {"cubic", PatternKind::cubic},     {"cylindrical", PatternKind::cylindrical},
    {"dents", PatternKind::dents},     {"gradient", PatternKind::gradient},
    {"granite", PatternKind::granite}, {"hexagon", PatternKind::hexagon},
    {"leopard", PatternKind::leopard}, {"marble", PatternKind::marble},
    {"onion", PatternKind::onion},     {"planar", PatternKind::planar},
    {"quilted", PatternKind::quilted}, {"radial", PatternKind::radial},
    {"ripples", PatternKind::ripples}, {"spherical", PatternKind::spherical},
    {"spiral1", PatternKind::spiral1}, {"spiral2", PatternKind::spiral2},
    {"spotted", PatternKind::spotted}, {"waves", PatternKind::waves},
    {"wood", PatternKind::wood},       {"wrinkles", PatternKind::wrinkles},
};

std::array<double, 3> components(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

int wholeNumber(double value, int minimum, int maximum) {
    if (!(value >= minimum)) return minimum;
    return value >= maximum ? maximum : static_cast<int>(value);
}

bool isFractal(PatternKind kind) {
    return kind == PatternKind::mandel || kind == PatternKind::julia || kind == PatternKind::magnetMandel ||
           kind == PatternKind::magnetJulia;
}

}  // namespace

std::optional<NodeId> PatternParser::parse() {
    if (!tokens_.expect("{", "to begin the pattern")) return std::nullopt;
    const NestingGuard guard(tokens_);
    bool understood = guard.ok() && parseName();
    while (understood && !tokens_.peek().is("}")) understood = parseModifier();
    if (!understood) {
        tokens_.skipBlock();
        return std::nullopt;
    }
    tokens_.next();
    return build();
}

std::vector<NodeId> PatternParser::parsePigment() {
    const Token word = tokens_.peek();
    if (!tokens_.expect("{", "to begin the pigment")) return {};
    const NestingGuard guard(tokens_);
    ColorRamp ramp;
    bool plain = false;
    if (!guard.ok() || !parsePigmentBody(ramp, plain)) {
        tokens_.skipBlock();
        tokens_.context().report({Severity::leftOut,
                                  "left-out",
                                  word.range,
                                  "This pigment is not simulated in a function.",
                                  {},
                                  {}});
        return {};
    }
    tokens_.next();
    const Expression value = plain ? scope_.constant(0) : scope_.expression(build());
    std::vector<NodeId> results;
    for (double (*pick)(const Color&) :
         {+[](const Color& c) -> double { return c.red; }, +[](const Color& c) -> double { return c.green; },
          +[](const Color& c) -> double { return c.blue; },
          +[](const Color& c) -> double { return c.filter; },
          +[](const Color& c) -> double { return c.transmit; }})
        results.push_back(rampValue(ramp, value, pick).node());
    return results;
}

bool PatternParser::parsePigmentBody(ColorRamp& ramp, bool& plain) {
    static constexpr std::array<std::string_view, 6> special{"mandel",   "julia",  "magnet",
                                                             "function", "object", "pigment_pattern"};
    const std::string_view name = tokens_.peek().text;
    const bool pattern =
        kinds.contains(name) || std::find(special.begin(), special.end(), name) != special.end();
    plain = !pattern;
    if (plain) {
        if (!parseColors(ramp)) return false;
        return tokens_.peek().is("}");
    }
    if (!parseName()) return false;
    while (!tokens_.peek().is("}")) {
        static constexpr std::array<std::string_view, 4> maps{"pigment_map", "color_map", "colour_map",
                                                              "quick_color"};
        const Token word = tokens_.peek();
        if (tokens_.accept("color_map") || tokens_.accept("colour_map")) {
            if (!ColorRampParser(tokens_).parse(ramp)) return false;
        } else if (std::find(maps.begin(), maps.end(), word.text) != maps.end()) {
            return false;
        } else if (!parseColors(ramp) && !parseModifier()) {
            return false;
        }
    }
    // Patterns have colours of their own when nothing is said.
    return !ramp.entries.empty();
}

bool PatternParser::parseColors(ColorRamp& ramp) {
    ExpressionParser expressions(tokens_);
    bool found = false;
    while (expressions.atExpression()) {
        ColorRamp::Entry entry;
        entry.position = static_cast<double>(ramp.entries.size());
        entry.color = expressions.parseColor();
        ramp.entries.push_back(entry);
        tokens_.accept(",");
        found = true;
    }
    return found;
}

bool PatternParser::leaveOut(const Token& word) {
    tokens_.context().report({Severity::leftOut,
                              "left-out",
                              word.range,
                              "The pattern `" + std::string(word.text) + "` is not simulated in a function.",
                              {},
                              {}});
    return false;
}

bool PatternParser::parseName() {
    const Token name = tokens_.peek();
    const auto kind = kinds.find(name.text);
    if (kind == kinds.end()) return parseSpecialName(name);
    tokens_.next();
    pattern_.kind = kind->second;
    parseNameArguments();
    return true;
}

void PatternParser::parseNameArguments() {
    ExpressionParser expressions(tokens_);
    if (pattern_.kind == PatternKind::gradient) pattern_.gradient = components(expressions.parseVector());
    if (pattern_.kind == PatternKind::spiral1 || pattern_.kind == PatternKind::spiral2)
        pattern_.arms = wholeNumber(expressions.parseFloat(), -10'000, 10'000);
}

bool PatternParser::parseSpecialName(const Token& name) {
    static constexpr std::array<std::string_view, 2> pictures{"image_pattern", "density_file"};
    if (std::find(pictures.begin(), pictures.end(), name.text) != pictures.end()) return leaveOut(name);
    if (parseFractal(name)) return true;
    if (tokens_.accept("magnet")) return parseMagnet();
    if (tokens_.accept("function")) return parseFunctionPattern();
    if (tokens_.accept("object")) return parseObjectPattern() || leaveOut(name);
    if (tokens_.accept("pigment_pattern")) return parsePigmentPattern() || leaveOut(name);
    tokens_.context().error("unknown-pattern", name.range, "Expected the name of a pattern here.");
    return false;
}

bool PatternParser::parseFractal(const Token& name) {
    ExpressionParser expressions(tokens_);
    if (tokens_.accept("mandel")) {
        pattern_.kind = PatternKind::mandel;
    } else if (tokens_.accept("julia")) {
        pattern_.kind = PatternKind::julia;
        const glm::dvec3 point = expressions.parseVector();
        pattern_.juliaPoint = {point.x, point.y};
        tokens_.accept(",");
    } else {
        return false;
    }
    const double iterations = expressions.parseFloat();
    pattern_.iterations = wholeNumber(iterations, 0, fractalIterationLimit);
    if (iterations > fractalIterationLimit)
        tokens_.context().warning("bad-value", tokens_.lastRange(),
                                  "`" + std::string(name.text) + "` is computed with at most " +
                                      std::to_string(fractalIterationLimit) + " iterations.");
    return true;
}

bool PatternParser::parseMagnet() {
    pattern_.magnetType = wholeNumber(ExpressionParser(tokens_).parseFloat(), 1, 2);
    const Token name = tokens_.peek();
    if (!parseFractal(name)) {
        tokens_.context().error("unknown-pattern", name.range,
                                "Expected `mandel` or `julia` behind `magnet`.");
        return false;
    }
    pattern_.kind =
        pattern_.kind == PatternKind::mandel ? PatternKind::magnetMandel : PatternKind::magnetJulia;
    return true;
}

bool PatternParser::parseFunctionPattern() {
    const FunctionValue value = FunctionParser(tokens_).parse();
    if (!value.function.valid()) return false;
    pattern_.kind = PatternKind::function;
    pattern_.function = value.function;
    if (value.function.argumentCount == 3 && value.function.results.size() == 1) return true;
    tokens_.context().error("wrong-function", tokens_.lastRange(),
                            "A pattern needs a function of x, y and z that gives one number.");
    return false;
}

bool PatternParser::parseObjectPattern() {
    const std::optional<Function> inside = parseInsideFunction(tokens_);
    if (!inside) return false;
    pattern_.kind = PatternKind::function;
    pattern_.function = *inside;
    return true;
}

bool PatternParser::parsePigmentPattern() {
    if (!tokens_.expect("{", "to begin `pigment_pattern`")) return false;
    FunctionScope inner({});
    PatternParser pattern(tokens_, inner);
    bool understood = pattern.parseName();
    ColorRamp ramp;
    while (understood && !tokens_.peek().is("}"))
        if (tokens_.accept("color_map") || tokens_.accept("colour_map"))
            understood = ColorRampParser(tokens_).parse(ramp);
        else
            understood = pattern.parseModifier();
    if (!understood) {
        tokens_.skipBlock();
        return false;
    }
    tokens_.next();
    const Expression value = inner.expression(pattern.build());
    const NodeId gray = grayOf(ramp, value).node();
    pattern_.kind = PatternKind::function;
    pattern_.function = inner.finish({gray});
    return true;
}

bool PatternParser::parseWave(const Token& word) {
    static const std::map<std::string_view, WaveForm> waves{
        {"ramp_wave", WaveForm::ramp},   {"triangle_wave", WaveForm::triangle},
        {"sine_wave", WaveForm::sine},   {"scallop_wave", WaveForm::scallop},
        {"cubic_wave", WaveForm::cubic}, {"poly_wave", WaveForm::poly},
    };
    const auto wave = waves.find(word.text);
    if (wave == waves.end()) return false;
    tokens_.next();
    pattern_.wave = wave->second;
    ExpressionParser expressions(tokens_);
    if (wave->second == WaveForm::poly && expressions.atExpression())
        pattern_.waveExponent = expressions.parseFloat();
    return true;
}

bool PatternParser::parseCrackleModifier(const Token& word) {
    const std::string_view name = word.text;
    if (pattern_.kind != PatternKind::crackle ||
        (name != "form" && name != "metric" && name != "offset" && name != "solid"))
        return false;
    tokens_.next();
    ExpressionParser expressions(tokens_);
    if (name == "form") pattern_.crackle.form = components(expressions.parseVector());
    if (name == "metric") pattern_.crackle.metric = expressions.parseFloat();
    if (name == "offset") pattern_.crackle.offset = expressions.parseFloat();
    if (name == "solid") pattern_.crackle.solid = true;
    return true;
}

FractalColoring PatternParser::parseColoring() {
    ExpressionParser expressions(tokens_);
    FractalColoring coloring;
    coloring.type = wholeNumber(expressions.parseFloat(), 0, 100);
    tokens_.accept(",");
    coloring.factor = expressions.parseFloat();
    return coloring;
}

bool PatternParser::parseFractalModifier(const Token& word) {
    if (!isFractal(pattern_.kind)) return false;
    if (tokens_.accept("exponent"))
        pattern_.exponent = wholeNumber(ExpressionParser(tokens_).parseFloat(), 0, 100);
    else if (tokens_.accept("exterior"))
        pattern_.exterior = parseColoring();
    else if (tokens_.accept("interior"))
        pattern_.interior = parseColoring();
    else
        return false;
    return !word.text.empty();
}

bool PatternParser::parseShapeModifier(const Token& word) {
    struct Entry {
        const char* name;
        PatternKind kind;
        double Pattern::*member;
    };
    static constexpr std::array<Entry, 4> entries{
        {{"agate_turb", PatternKind::agate, &Pattern::agateTurbulence},
         {"mortar", PatternKind::brick, &Pattern::mortar},
         {"control0", PatternKind::quilted, &Pattern::control0},
         {"control1", PatternKind::quilted, &Pattern::control1}}};
    for (const Entry& entry : entries)
        if (entry.kind == pattern_.kind && word.is(entry.name)) {
            tokens_.next();
            pattern_.*entry.member = ExpressionParser(tokens_).parseFloat();
            return true;
        }
    if (pattern_.kind != PatternKind::brick || !tokens_.accept("brick_size")) return false;
    pattern_.brickSize = components(ExpressionParser(tokens_).parseVector());
    return true;
}

bool PatternParser::parseGeneralModifier(const Token& word) {
    ExpressionParser expressions(tokens_);
    if (tokens_.accept("turbulence"))
        pattern_.turbulence = components(expressions.parseVector());
    else if (tokens_.accept("octaves"))
        pattern_.octaves = wholeNumber(expressions.parseFloat(), 1, 10);
    else if (tokens_.accept("lambda"))
        pattern_.lambda = expressions.parseFloat();
    else if (tokens_.accept("omega"))
        pattern_.omega = expressions.parseFloat();
    else if (tokens_.accept("frequency"))
        pattern_.frequency = expressions.parseFloat();
    else if (tokens_.accept("phase"))
        pattern_.phase = expressions.parseFloat();
    else if (tokens_.accept("noise_generator"))
        pattern_.noiseGenerator = wholeNumber(expressions.parseFloat(), 0, 3);
    else
        return false;
    return word.kind == TokenKind::word;
}

bool PatternParser::parseModifier() {
    Transform transform;
    if (TransformParser(tokens_).parseModifier(transform)) {
        pattern_.warps.emplace_back(transformWarp(transform));
        return true;
    }
    const Token word = tokens_.peek();
    if (tokens_.accept("warp")) {
        const std::optional<PatternWarp> warp = WarpParser(tokens_).parse();
        if (warp) pattern_.warps.push_back(*warp);
        return warp.has_value();
    }
    if (parseWave(word) || parseCrackleModifier(word) || parseFractalModifier(word) ||
        parseShapeModifier(word) || parseGeneralModifier(word))
        return true;
    tokens_.context().error("unknown-modifier", word.range,
                            "Expected a modifier of the pattern or `}` here.");
    return false;
}

NodeId PatternParser::build() {
    const Expression x = scope_.expression(*scope_.find("x")), y = scope_.expression(*scope_.find("y")),
                     z = scope_.expression(*scope_.find("z"));
    return buildPattern(pattern_, x, y, z, tokens_.context().noiseGenerator).node();
}

}  // namespace isoscope
