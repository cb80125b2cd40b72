// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/pattern_parser.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>

#include "core/language/expression_parser.h"
#include "core/language/transform_parser.h"

namespace isoscope {

namespace {

const std::map<std::string_view, PatternKind> kinds{
    {"agate", PatternKind::agate},         {"boxed", PatternKind::boxed},
    {"bozo", PatternKind::bozo},           {"brick", PatternKind::brick},
    {"bumps", PatternKind::bumps},         {"checker", PatternKind::checker},
    {"crackle", PatternKind::crackle},     {"cylindrical", PatternKind::cylindrical},
    {"dents", PatternKind::dents},         {"gradient", PatternKind::gradient},
    {"granite", PatternKind::granite},     {"hexagon", PatternKind::hexagon},
    {"leopard", PatternKind::leopard},     {"mandel", PatternKind::mandel},
    {"marble", PatternKind::marble},       {"onion", PatternKind::onion},
    {"planar", PatternKind::planar},       {"radial", PatternKind::radial},
    {"ripples", PatternKind::ripples},     {"spherical", PatternKind::spherical},
    {"spiral1", PatternKind::spiral1},     {"spiral2", PatternKind::spiral2},
    {"spotted", PatternKind::spotted},     {"waves", PatternKind::waves},
    {"wood", PatternKind::wood},           {"wrinkles", PatternKind::wrinkles},
};

std::array<double, 3> components(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

/// A count, cut to what may be unrolled.
int wholeNumber(double value, int minimum, int maximum) {
    if (!(value >= minimum)) return minimum;
    return value >= maximum ? maximum : static_cast<int>(value);
}

}  // namespace

std::optional<NodeId> PatternParser::parse() {
    if (!tokens_.expect("{", "to begin the pattern")) return std::nullopt;
    bool understood = parseName();
    while (understood && !tokens_.peek().is("}")) understood = parseModifier();
    if (!understood) {
        tokens_.skipBlock();
        return std::nullopt;
    }
    tokens_.next();
    return build();
}

bool PatternParser::leaveOut(const Token& word) {
    tokens_.context().leftOut(word.range, "the pattern `" + std::string(word.text) + "` in a function");
    return false;
}

bool PatternParser::parseName() {
    const Token name = tokens_.peek();
    const auto kind = kinds.find(name.text);
    if (kind != kinds.end()) {
        tokens_.next();
        pattern_.kind = kind->second;
        return parseNameArguments(name);
    }
    static constexpr std::array<std::string_view, 11> later{"cells",       "cubic",    "quilted",      "julia",
                                                            "magnet",      "function", "image_pattern", "object",
                                                            "density_file", "pigment_pattern", "spherical"};
    if (std::find(later.begin(), later.end(), name.text) != later.end()) return leaveOut(name);
    tokens_.context().error("unknown-pattern", name.range, "Expected the name of a pattern here.");
    return false;
}

bool PatternParser::parseNameArguments(const Token&) {
    ExpressionParser expressions(tokens_);
    switch (pattern_.kind) {
        case PatternKind::gradient: pattern_.gradient = components(expressions.parseVector()); break;
        case PatternKind::mandel: pattern_.iterations = wholeNumber(expressions.parseFloat(), 0, 10'000); break;
        case PatternKind::spiral1:
        case PatternKind::spiral2: pattern_.arms = wholeNumber(expressions.parseFloat(), -10'000, 10'000); break;
        default: break;
    }
    return true;
}

bool PatternParser::parseWave(const Token& word) {
    static const std::map<std::string_view, WaveForm> waves{
        {"ramp_wave", WaveForm::ramp},       {"triangle_wave", WaveForm::triangle}, {"sine_wave", WaveForm::sine},
        {"scallop_wave", WaveForm::scallop}, {"cubic_wave", WaveForm::cubic},       {"poly_wave", WaveForm::poly},
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

bool PatternParser::parseModifier() {
    if (TransformParser(tokens_).parseModifier(transform_)) return true;
    const Token word = tokens_.peek();
    if (parseWave(word) || parseCrackleModifier(word)) return true;
    if (word.is("warp")) return leaveOut(word);
    const std::string_view name = word.text;
    tokens_.next();
    ExpressionParser expressions(tokens_);
    if (word.is("turbulence"))
        pattern_.turbulence = components(expressions.parseVector());
    else if (word.is("octaves"))
        pattern_.octaves = wholeNumber(expressions.parseFloat(), 1, 10);
    else if (word.is("lambda"))
        pattern_.lambda = expressions.parseFloat();
    else if (word.is("omega"))
        pattern_.omega = expressions.parseFloat();
    else if (word.is("frequency"))
        pattern_.frequency = expressions.parseFloat();
    else if (word.is("phase"))
        pattern_.phase = expressions.parseFloat();
    else if (word.is("noise_generator"))
        pattern_.noiseGenerator = wholeNumber(expressions.parseFloat(), 0, 3);
    else if (word.is("agate_turb") && pattern_.kind == PatternKind::agate)
        pattern_.agateTurbulence = expressions.parseFloat();
    else if (word.is("brick_size") && pattern_.kind == PatternKind::brick)
        pattern_.brickSize = components(expressions.parseVector());
    else if (word.is("mortar") && pattern_.kind == PatternKind::brick)
        pattern_.mortar = expressions.parseFloat();
    else if (word.is("exponent") || word.is("interior") || word.is("exterior"))
        return leaveOut(word);
    else {
        tokens_.pushBack(word);
        tokens_.context().error("unknown-modifier", word.range,
                                "`" + std::string(name) + "` is no modifier of a pattern.");
        return false;
    }
    return true;
}

NodeId PatternParser::build() {
    const Expression x = scope_.expression(*scope_.find("x")), y = scope_.expression(*scope_.find("y")),
                     z = scope_.expression(*scope_.find("z"));
    std::array<Expression, 3> point{x, y, z};
    if (!transform_.identity()) {
        const glm::dmat4& m = transform_.backward();
        for (int row = 0; row < 3; ++row)
            point[static_cast<std::size_t>(row)] = x * m[0][row] + y * m[1][row] + z * m[2][row] + m[3][row];
    }
    return buildPattern(pattern_, point[0], point[1], point[2], tokens_.context().noiseGenerator).node();
}

}  // namespace isoscope
