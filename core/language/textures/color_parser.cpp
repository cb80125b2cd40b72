// SPDX-License-Identifier: GPL-3.0-or-later
// Colour expressions of ExpressionParser.
#include <algorithm>

#include "core/language/expressions/expression_parser.h"
#include "core/language/textures/color_start.h"
#include "core/language/tokens/nesting_guard.h"
#include "core/scene/scene.h"
#include "core/texture/image_file.h"

namespace isoscope {

namespace {

bool isColorWord(const Token& token) { return token.is("color") || token.is("colour"); }

/// `rgb` and its siblings: a letter for each channel, behind an s where they are stored as sRGB.
bool isColorKeyword(const Token& token) {
    const std::string_view text = token.text.substr(token.text.starts_with('s') ? 1 : 0);
    return token.kind == TokenKind::word &&
           (text == "rgb" || text == "rgbf" || text == "rgbt" || text == "rgbft");
}

std::optional<int> channelOf(const Token& token) {
    if (token.is("red")) return 0;
    if (token.is("green")) return 1;
    if (token.is("blue")) return 2;
    if (token.is("filter") || token.is("alpha")) return 3;
    if (token.is("transmit")) return 4;
    return std::nullopt;
}

}  // namespace

bool ExpressionParser::atColor() {
    const Token& token = tokens_.peek();
    return !first_ && (isColorWord(token) || isColorKeyword(token) || channelOf(token));
}

Operand ExpressionParser::colorExpression() {
    const NestingGuard guard(tokens_);
    if (!guard.ok()) return fail({}, {}, {});
    VectorValue color;
    color.count = 5;
    color.color = true;
    bool any = false, failed = false;
    // `color rgb 1 filter 0.5`, `color red 1 green 1`, `Red transmit 0.5`: channels may follow. Another
    // `color` or `rgb` begins the next colour of a list.
    std::optional<Token> word;
    if (isColorWord(tokens_.peek())) word = tokens_.next();
    if (word && (isColorWord(tokens_.peek()) || isWithoutColor(tokens_))) {
        context().warning(
            "empty-color", word->range,
            "There is no value behind `" + std::string(word->text) + "`, which makes it black.");
        return Operand::of(color);
    }
    while (!failed) {
        if (!any && isColorKeyword(tokens_.peek())) {
            const Token keyword = tokens_.next();
            Operand value = sum();
            consume(value);
            failed = value.failed;
            applyColorKeyword(keyword, value, color);
        } else if (const std::optional<int> channel = channelOf(tokens_.peek())) {
            tokens_.next();
            color.components[static_cast<std::size_t>(*channel)] = parseFloat();
        } else if (!any) {
            Operand value = sum();
            consume(value);
            failed = value.failed;
            color.components = widened(value.vector, 5).components;
        } else {
            break;
        }
        any = true;
    }
    Operand result = Operand::of(color);
    result.failed = failed;
    return result;
}

void ExpressionParser::decodeStored(const Token& keyword, VectorValue& color) {
    if (!context().hasAssumedGamma)
        context().warning(
            "missing-gamma", keyword.range,
            "`" + std::string(keyword.text) + "` depends on `assumed_gamma`, which has not been set.",
            "begin with `global_settings { assumed_gamma 1 }`, or POV-Ray will refuse the scene");
    const bool stated = context().hasAssumedGamma || context().languageVersion >= 370;
    const double gamma = stated ? context().assumedGamma : srgbGamma;
    for (std::size_t i = 0; i < 3; ++i)
        color.components[i] = sceneColor(color.components[i], gamma, srgbGamma);
}

void ExpressionParser::applyColorKeyword(const Token& keyword, const Operand& value, VectorValue& color) {
    if (value.failed) return;
    const bool stored = keyword.text.starts_with('s');
    const std::string_view letters = keyword.text.substr(stored ? 1 : 0);
    const std::size_t channels = letters.size();
    const auto count = static_cast<std::size_t>(value.vector.count);
    VectorValue v = value.vector;
    if (count == 1) v = widened(v, static_cast<int>(channels));
    if (count > channels)
        context().warning("suspicious-color", keyword.range,
                          "`" + std::string(keyword.text) + "` expects " + std::to_string(channels) +
                              " components, but all " + std::to_string(count) + " of this color are taken.",
                          "leave `" + std::string(keyword.text) + "` out");
    color.components = widened(v, 5).components;
    if (stored) decodeStored(keyword, color);
    for (std::size_t i = std::max(channels, count); i < 5; ++i) color.components[i] = 0;
    if (letters == "rgbt") {
        color.components[4] = color.components[3];
        color.components[3] = 0;
    }
}

}  // namespace isoscope
