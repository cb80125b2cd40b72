// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/textures/finish_parser.h"

#include <algorithm>
#include <array>

#include "core/language/expressions/declared_value.h"
#include "core/language/expressions/expression_parser.h"
#include "core/language/tokens/povray_refusals.h"
#include "core/language/tokens/unknown_name.h"

namespace isoscope {

constexpr std::array<const char*, 3> FinishParser::itemWords{
    "ambient emission diffuse brilliance phong phong_size specular roughness crand metallic conserve_energy "
    "reflection irid subsurface use_alpha"};

namespace {

/// Whether a word is one of a list with spaces between. (The lists of block_words.h are made for messages,
/// which a text without mistakes should not wait for.)
bool isListed(std::string_view list, std::string_view word) {
    while (!list.empty()) {
        const std::size_t end = std::min(list.find(' '), list.size());
        if (list.substr(0, end) == word) return true;
        list.remove_prefix(std::min(end + 1, list.size()));
    }
    return false;
}

}  // namespace

Finish FinishParser::parse(const Finish& start) {
    finish_ = start;
    if (!tokens_.expect("{", "to begin `finish`")) return finish_;
    for (bool isFirst = true; !tokens_.peek().is("}"); isFirst = false) {
        const Token word = tokens_.peek();
        if (const std::optional<Finish> declared = takeDeclared<Finish>(tokens_)) {
            finish_ = *declared;
            if (!isFirst) warnOfLateName(tokens_.context(), word, "finish");
            continue;
        }
        if (parseItem()) continue;
        const Token token = tokens_.peek();
        if (token.kind == TokenKind::end) {
            tokens_.expect("}", "to close `finish`");
            return finish_;
        }
        passUnknownItem(tokens_, "finish");
    }
    tokens_.next();
    return finish_;
}

bool FinishParser::parseItem() {
    if (tokens_.accept("ambient"))
        finish_.ambient = parseAmount();
    else if (tokens_.accept("emission"))
        finish_.emission = parseAmount();
    else if (tokens_.accept("metallic"))
        finish_.metallic = parseOptionalNumber(1);
    else if (tokens_.accept("conserve_energy"))
        finish_.conserveEnergy = parseOptionalNumber(1) != 0;
    else if (tokens_.accept("reflection"))
        parseReflection();
    else
        return parseDiffuse() || parseNumberItem() || parseIrid() || parseLeftOut();
    return true;
}

bool FinishParser::parseDiffuse() {
    if (!tokens_.accept("diffuse")) return false;
    finish_.diffuseAlbedo = tokens_.accept("albedo");
    finish_.diffuse = ExpressionParser(tokens_).parseFloat();
    tokens_.accept(",");
    ExpressionParser back(tokens_);
    if (back.atExpression()) finish_.diffuseBack = back.parseFloat();
    return true;
}

bool FinishParser::parseNumberItem() {
    struct Entry {
        const char* word;
        double Finish::*member;
    };
    static constexpr std::array<Entry, 7> entries{{{"brilliance", &Finish::brilliance},
                                                   {"phong", &Finish::phong},
                                                   {"phong_size", &Finish::phongSize},
                                                   {"specular", &Finish::specular},
                                                   {"roughness", &Finish::roughness},
                                                   {"crand", &Finish::crand},
                                                   {"reflection_exponent", &Finish::reflectionExponent}}};
    for (const Entry& entry : entries)
        if (tokens_.accept(entry.word)) {
            const bool albedo = tokens_.accept("albedo");
            if (entry.member == &Finish::phong) finish_.phongAlbedo = albedo;
            if (entry.member == &Finish::specular) finish_.specularAlbedo = albedo;
            finish_.*entry.member = ExpressionParser(tokens_).parseFloat();
            return true;
        }
    return false;
}

void FinishParser::parseReflection() {
    if (tokens_.accept("{")) return parseReflectionBlock();
    finish_.reflectionFalloff = 1;
    finish_.reflectionFresnel = false;
    finish_.reflectionMetallic = 0;
    // Without a block the same at every angle.
    finish_.reflectionMinimum = finish_.reflectionMaximum = parseAmount();
}

void FinishParser::parseReflectionBlock() {
    ExpressionParser expressions(tokens_);
    if (!tokens_.peek().is("}") && expressions.atExpression()) {
        finish_.reflectionMaximum = parseAmount();
        finish_.reflectionMinimum = finish_.reflectionMaximum;
        tokens_.accept(",");
        // With two colours the first is the smaller one; a single one counts for every angle.
        if (!tokens_.peek().is("}") && expressions.atExpression()) finish_.reflectionMaximum = parseAmount();
    }
    while (!tokens_.accept("}")) {
        const Token word = tokens_.peek();
        if (parseReflectionItem()) continue;
        tokens_.expect("}", "to close `reflection`");
        return word.kind == TokenKind::end ? void() : tokens_.skipBlock();
    }
}

bool FinishParser::parseReflectionItem() {
    if (tokens_.accept("falloff"))
        finish_.reflectionFalloff = ExpressionParser(tokens_).parseFloat();
    else if (tokens_.accept("exponent"))
        finish_.reflectionExponent = ExpressionParser(tokens_).parseFloat();
    else if (tokens_.accept("fresnel"))
        finish_.reflectionFresnel = parseOptionalNumber(1) != 0;
    else if (tokens_.accept("metallic"))
        finish_.reflectionMetallic = parseOptionalNumber(1);
    else
        return false;
    return true;
}

bool FinishParser::parseIrid() {
    if (!tokens_.accept("irid")) return false;
    if (!tokens_.expect("{", "to begin `irid`")) return true;
    ExpressionParser expressions(tokens_);
    // Of a film of less than nothing POV-Ray shows none.
    finish_.irid = std::max(0.0, expressions.parseFloat());
    for (;;) {
        if (tokens_.accept("thickness")) {
            finish_.iridThickness = expressions.parseFloat();
        } else if (tokens_.accept("turbulence")) {
            // Of a vector POV-Ray takes x.
            finish_.iridTurbulence = expressions.parseVector().x;
        } else if (tokens_.accept("}")) {
            return true;
        } else {
            tokens_.context().error("unexpected-token", tokens_.peek().range,
                                    "Expected `}` to close `irid`.");
            tokens_.skipBlock();
            return true;
        }
    }
}

bool FinishParser::parseLeftOut() {
    const Token word = tokens_.peek();
    if (word.is("subsurface")) {
        tokens_.next();
        leaveOut(word.text);
        if (tokens_.accept("{")) tokens_.skipBlock();
        return true;
    }
    if (word.is("use_alpha") || word.is("ior") || word.is("refraction")) {
        tokens_.next();
        leaveOut(word.text);
        if (ExpressionParser(tokens_).atExpression()) ExpressionParser(tokens_).parseFloat();
        return true;
    }
    return false;
}

void FinishParser::leaveOut(std::string_view word) {
    std::vector<std::string>& all = finish_.notSimulated;
    if (std::find(all.begin(), all.end(), word) == all.end()) all.emplace_back(word);
}

/// As in POV-Ray, 0 where the block ends or its next item begins.
Color FinishParser::parseAmount() {
    if (tokens_.peek().is("}") || isListed(itemWords[0], tokens_.peek().text)) return {};
    const SourceRange start = tokens_.peek().range;
    const std::optional<Value> value = ExpressionParser(tokens_).parseValue();
    if (!value) return {};
    if (const auto* number = std::get_if<NumberValue>(&value->data))
        return {number->value, number->value, number->value};
    if (const auto* vector = std::get_if<VectorValue>(&value->data)) {
        const auto& c = vector->components;
        return {c[0], c[1], c[2], c[3], c[4]};
    }
    tokens_.context().error("not-a-color", rangeSince(start, tokens_), "Expected a float or a colour here.");
    return {};
}

double FinishParser::parseOptionalNumber(double otherwise) {
    ExpressionParser expressions(tokens_);
    return expressions.atExpression() ? expressions.parseFloat() : otherwise;
}

}  // namespace isoscope
