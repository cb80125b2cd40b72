// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/textures/color_start.h"

#include <algorithm>
#include <array>

#include "core/language/expressions/expression_parser.h"
#include "core/language/expressions/value.h"
#include "core/language/tokens/povray_refusals.h"
#include "core/language/tokens/words.h"

namespace isoscope {

bool atColor(TokenStream& tokens) {
    static constexpr std::array<std::string_view, 13> words{"color", "colour", "rgb",   "rgbf",  "rgbt",
                                                            "rgbft", "srgb",   "srgbf", "srgbt", "srgbft",
                                                            "red",   "green",  "blue"};
    const Token& token = tokens.peek();
    if (token.is("<")) return true;
    if (token.kind != TokenKind::word) return false;
    if (std::ranges::find(words, token.text) != words.end()) return true;
    const Value* value = tokens.context().symbols.find(token.text);
    if (!value) return false;
    const auto isVector = [](const Value& v) { return std::holds_alternative<VectorValue>(v.data); };
    const auto* array = std::get_if<std::shared_ptr<ArrayValue>>(&value->data);
    return isVector(*value) ||
           (array && *array && std::any_of((*array)->elements.begin(), (*array)->elements.end(), isVector));
}

bool isWithoutColor(TokenStream& tokens) {
    const Token& token = tokens.peek();
    const bool isUnknown = token.kind == TokenKind::word && !isReservedWord(token.text);
    const bool isChannel = token.is("filter") || token.is("transmit") || token.is("alpha");
    return token.kind != TokenKind::end && !isUnknown && !isChannel && !atColor(tokens) &&
           !ExpressionParser(tokens).atExpression();
}

void warnOfBareVector(TokenStream& tokens) {
    const Token token = tokens.peek();
    const Value* value = token.kind == TokenKind::word ? tokens.context().symbols.find(token.text) : nullptr;
    const auto* vector = value ? std::get_if<VectorValue>(&value->data) : nullptr;
    constexpr int colorComponents = 5;
    if (token.is("<") || (vector && vector->count < colorComponents))
        warnOfMissing(tokens.context(), token.range, "wants `rgb` in front of a vector as a colour.", "rgb");
}

}  // namespace isoscope
