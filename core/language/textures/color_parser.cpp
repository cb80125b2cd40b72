// SPDX-License-Identifier: GPL-3.0-or-later
// Colour expressions of ExpressionParser.
#include "core/language/expressions/expression_parser.h"
#include "core/language/tokens/nesting_guard.h"

namespace isoscope {

namespace {

bool isColorWord(const Token& token) { return token.is("color") || token.is("colour"); }

bool isColorKeyword(const Token& token) {
    return token.is("rgb") || token.is("rgbf") || token.is("rgbt") || token.is("rgbft");
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
    while (isColorWord(tokens_.peek())) tokens_.next();
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

void ExpressionParser::applyColorKeyword(const Token& keyword, const Operand& value, VectorValue& color) {
    if (value.failed) return;
    const std::size_t channels = keyword.text.size();  // the keyword has a letter for each
    const auto count = static_cast<std::size_t>(value.vector.count);
    VectorValue v = value.vector;
    if (count == 1) v = widened(v, static_cast<int>(channels));
    if (count > channels) {
        if (count == 5)
            context().warning("suspicious-color", keyword.range,
                              "`" + std::string(keyword.text) + "` expects " + std::to_string(channels) +
                                  " components, but all 5 of this color are taken.",
                              "leave `" + std::string(keyword.text) + "` out");
        else
            fail("bad-vector", keyword.range,
                 "`" + std::string(keyword.text) + "` expects " + std::to_string(channels) +
                     " components, but this has " + std::to_string(count) + ".");
    }
    color.components = widened(v, 5).components;
    if (count == 5) return;
    for (std::size_t i = channels; i < 5; ++i) color.components[i] = 0;
    if (keyword.text == "rgbt") {
        color.components[4] = color.components[3];
        color.components[3] = 0;
    }
}

}  // namespace isoscope
