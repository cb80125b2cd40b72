// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/pigment_parser.h"

#include <algorithm>
#include <array>

#include "core/language/declared_value.h"
#include "core/language/expression_parser.h"
#include "core/language/keywords.h"
#include "core/language/nesting_guard.h"
#include "core/language/transform_parser.h"

namespace isoscope {

namespace {

template <std::size_t count>
bool isOneOf(std::string_view word, const std::array<std::string_view, count>& words) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

void PigmentParser::Mean::add(const Color& color) {
    sum = sum + color;
    ++count;
}

Color PigmentParser::Mean::value() const {
    return count > 0 ? sum * (1.0 / count) : Color{0.5, 0.5, 0.5, 0, 0};
}

bool PigmentParser::isMap(std::string_view word) {
    static constexpr std::array<std::string_view, 4> maps{"color_map", "colour_map", "pigment_map",
                                                          "density_map"};
    return isOneOf(word, maps);
}

Pigment PigmentParser::parse(const Pigment& start) {
    if (const auto* solid = std::get_if<SolidPigment>(&start)) {
        color_ = solid->color;
        standsFor_ = solid->standsFor;
    }
    if (tokens_.expect("{", "to begin `pigment`")) parseBody("}");
    return result();
}

Pigment PigmentParser::result() const {
    if (mean_.count > 0 || !color_) return SolidPigment{mean_.value(), standsFor_};
    return SolidPigment{*color_, standsFor_};
}

void PigmentParser::parseBody(std::string_view end) {
    const NestingGuard guard(tokens_);
    if (!guard.ok()) return tokens_.skipBlock();
    while (!tokens_.peek().is(end)) {
        const Token token = tokens_.peek();
        Transform ignored;
        if (startFromDeclared() || parseColorItem() || TransformParser(tokens_).parseModifier(ignored) ||
            parsePatternItem())
            continue;
        if (token.kind == TokenKind::end) {
            tokens_.expect(end, "to close `pigment`");
            return;
        }
        tokens_.context().error("unknown-item", token.range,
                                describe(token) + " is not understood in `pigment`.");
        if (end == "}") return tokens_.skipBlock();
        tokens_.next();
    }
    tokens_.next();
}

bool PigmentParser::startFromDeclared() {
    const std::optional<Pigment> declared = takeDeclared<Pigment>(tokens_);
    if (!declared) return false;
    const SolidPigment& solid = std::get<SolidPigment>(*declared);
    color_ = solid.color;
    standsFor_ = solid.standsFor;
    return true;
}

bool PigmentParser::atColor() {
    static constexpr std::array<std::string_view, 9> words{"color", "colour", "rgb",   "rgbf", "rgbt",
                                                           "rgbft", "red",    "green", "blue"};
    const Token& token = tokens_.peek();
    if (token.is("<")) return true;
    if (token.kind != TokenKind::word) return false;
    if (isOneOf(token.text, words)) return true;
    const Value* value = tokens_.context().symbols.find(token.text);
    if (!value) return false;
    const auto isVector = [](const Value& v) { return std::holds_alternative<VectorValue>(v.data); };
    const auto* array = std::get_if<std::shared_ptr<ArrayValue>>(&value->data);
    return isVector(*value) ||
           (array && *array && std::any_of((*array)->elements.begin(), (*array)->elements.end(), isVector));
}

bool PigmentParser::parseColorItem() {
    if (tokens_.accept("quick_color") || tokens_.accept("quick_colour")) {
        ExpressionParser(tokens_).parseColor();
        return true;
    }
    // A vector behind the name of a pattern is its direction or size, not a colour.
    if (!atColor() || (tokens_.peek().is("<") && !standsFor_.empty())) {
        const bool filter = tokens_.peek().is("filter");
        if (!color_ || (!filter && !tokens_.peek().is("transmit"))) return false;
        tokens_.next();
        (filter ? color_->filter : color_->transmit) = ExpressionParser(tokens_).parseFloat();
        return true;
    }
    const Color color = ExpressionParser(tokens_).parseColor();
    if (standsFor_.empty())
        color_ = color;
    else
        mean_.add(color);
    return true;
}

bool PigmentParser::parsePatternItem() {
    const Token token = tokens_.peek();
    if (token.kind == TokenKind::end || token.is("}") || token.is("]")) return false;
    if (token.kind == TokenKind::word) {
        const Value* value = tokens_.context().symbols.find(token.text);
        if (!isKeyword(token.text) && !value) return false;
        tokens_.next();
        if (isMap(token.text)) {
            const Pigment map = PigmentParser(tokens_).parseMap();
            mean_.add(std::get<SolidPigment>(map).color);
        } else if (standsFor_.empty()) {
            // The first word names the pattern; what follows describes it.
            standsFor_ = std::string(token.text);
            color_.reset();
        }
        return true;
    }
    if (standsFor_.empty()) return false;
    tokens_.next();
    if (token.is("{")) tokens_.skipBlock();
    return true;
}

Pigment PigmentParser::parseMap() {
    Mean mean;
    if (!tokens_.expect("{", "to begin the map")) return SolidPigment{mean.value(), "a map"};
    while (!tokens_.accept("}")) {
        if (startFromDeclared()) {
            mean.add(*color_);
        } else if (!parseMapEntry(mean)) {
            const Token token = tokens_.peek();
            if (token.kind == TokenKind::end) {
                tokens_.expect("}", "to close the map");
                break;
            }
            tokens_.context().error(
                "unknown-item", token.range,
                "Expected `[`, a position and a colour here, but found " + describe(token) + ".");
            tokens_.skipBlock();
            break;
        }
    }
    return SolidPigment{mean.value(), "a map"};
}

bool PigmentParser::parseMapEntry(Mean& mean) {
    if (!tokens_.accept("[")) return false;
    // `average` may go without weights.
    if (ExpressionParser(tokens_).atExpression() && !atColor()) ExpressionParser(tokens_).parseFloat();
    tokens_.accept(",");
    // An entry of the old form gives two positions and two colours.
    if (!atColor() && ExpressionParser(tokens_).atExpression() && tokens_.peek().kind != TokenKind::word)
        ExpressionParser(tokens_).parseFloat();
    PigmentParser entry(tokens_);
    entry.parseBody("]");
    mean.add(std::get<SolidPigment>(entry.result()).color);
    return true;
}

}  // namespace isoscope
