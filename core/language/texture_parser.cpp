// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/texture_parser.h"

#include <algorithm>

#include "core/language/declared_value.h"
#include "core/language/expression_parser.h"
#include "core/language/finish_parser.h"
#include "core/language/keywords.h"
#include "core/language/nesting_guard.h"
#include "core/language/pigment_parser.h"
#include "core/language/transform_parser.h"

namespace isoscope {

void addNotSimulated(std::vector<std::string>& list, std::string_view keyword) {
    if (std::find(list.begin(), list.end(), keyword) == list.end()) list.emplace_back(keyword);
}

std::vector<std::string> leftOutSentences(const Material& material) {
    std::vector<std::string> sentences;
    for (const std::string& word : notSimulatedIn(material.pigment))
        sentences.push_back(word == "uv_mapping" ? "`uv_mapping` is not simulated."
                                                 : "The pigment pattern `" + word + "` is drawn as one colour.");
    const auto some = [](const Color& c) { return c.red != 0 || c.green != 0 || c.blue != 0; };
    if (const auto* solid = std::get_if<SolidPigment>(&material.pigment);
        solid && (solid->color.filter != 0 || solid->color.transmit != 0))
        sentences.emplace_back(
            "Transparency (`filter`, `transmit`) is not simulated: the surface is drawn opaque.");
    if (some(material.finish.reflectionMinimum) || some(material.finish.reflectionMaximum))
        sentences.emplace_back("`reflection` is not simulated.");
    if (material.finish.crand != 0) sentences.emplace_back("`crand` is not simulated.");
    for (const auto* list : {&material.finish.notSimulated, &material.notSimulated})
        for (const std::string& keyword : *list) sentences.push_back("`" + keyword + "` is not simulated.");
    return sentences;
}

Material TextureParser::parseTexture() {
    Material material = defaults_;
    if (tokens_.expect("{", "to begin `texture`")) parseBody(material, "}", "texture");
    return material;
}

Material TextureParser::parseMaterial() {
    Material material = defaults_;
    if (!tokens_.expect("{", "to begin `material`")) return material;
    while (!tokens_.accept("}")) {
        Transform transform;
        const Token token = tokens_.peek();
        if (tokens_.accept("texture")) {
            material = parseTexture();
        } else if (tokens_.accept("interior") || tokens_.accept("interior_texture")) {
            addNotSimulated(material.notSimulated, token.text);
            if (tokens_.accept("{")) tokens_.skipBlock();
        } else if (!startFromDeclared(material) && !parsePart(material)) {
            if (TransformParser(tokens_).parseModifier(transform)) {
                material = moved(std::move(material), transform);
                continue;
            }
            if (token.kind == TokenKind::end) {
                tokens_.expect("}", "to close `material`");
                break;
            }
            tokens_.context().error("unknown-item", token.range,
                                    describe(token) + " is not understood in `material`.");
            tokens_.skipBlock();
            break;
        }
    }
    return material;
}

bool TextureParser::parsePart(Material& material) {
    if (tokens_.accept("pigment")) {
        material.pigment = PigmentParser(tokens_).parse(moved(material.pigment, material.pigmentTransform));
        material.pigmentTransform = Transform();
        return true;
    }
    if (tokens_.accept("finish")) {
        material.finish = FinishParser(tokens_).parse(material.finish);
        return true;
    }
    if (tokens_.accept("normal")) {
        addNotSimulated(material.notSimulated, "normal");
        if (tokens_.expect("{", "to begin `normal`")) tokens_.skipBlock();
        return true;
    }
    return false;
}

void TextureParser::parseBody(Material& material, std::string_view end, std::string_view keyword) {
    const NestingGuard guard(tokens_);
    if (!guard.ok()) return tokens_.skipBlock();
    while (!tokens_.peek().is(end)) {
        if (parseTextureItem(material)) continue;
        const Token token = tokens_.peek();
        if (token.kind == TokenKind::end) {
            tokens_.expect(end, "to close `" + std::string(keyword) + "`");
            return;
        }
        if (pattern_ || (token.kind == TokenKind::word && isKeyword(token.text))) {
            skipPatternItem();
            addNotSimulated(material.notSimulated, pattern_ ? "texture_map" : token.text);
            pattern_ = true;
            continue;
        }
        tokens_.context().error("unknown-item", token.range,
                                describe(token) + " is not understood in `" + std::string(keyword) + "`.");
        tokens_.skipBlock();
        return;
    }
    tokens_.next();
}

/// A token of a texture pattern, which is not drawn as such.
void TextureParser::skipPatternItem() {
    if (tokens_.next().is("{")) tokens_.skipBlock();
}

bool TextureParser::parseTextureItem(Material& material) {
    Transform transform;
    if (startFromDeclared(material) || parsePart(material)) return true;
    if (TransformParser(tokens_).parseModifier(transform)) {
        material = moved(std::move(material), transform);
        return true;
    }
    if (parseTextureMap(material)) return true;
    if (!tokens_.peek().is("texture")) return false;
    // `checker texture { A } texture { B }`: the first stands for all.
    tokens_.next();
    const bool first = pattern_ && std::find(material.notSimulated.begin(), material.notSimulated.end(),
                                             "texture_map") == material.notSimulated.end();
    const Material part = parseTexture();
    if (first) {
        material = part;
        addNotSimulated(material.notSimulated, "texture_map");
    }
    return true;
}

bool TextureParser::parseTextureMap(Material& material) {
    if (!tokens_.accept("texture_map")) return false;
    if (!tokens_.expect("{", "to begin `texture_map`")) return true;
    bool first = true;
    while (tokens_.accept("[")) {
        if (ExpressionParser(tokens_).atExpression()) ExpressionParser(tokens_).parseFloat();
        tokens_.accept(",");
        Material entry = defaults_;
        TextureParser(tokens_, defaults_).parseBody(entry, "]", "texture_map");
        if (first) material = entry;
        first = false;
    }
    addNotSimulated(material.notSimulated, "texture_map");
    if (!tokens_.accept("}")) tokens_.skipBlock();
    return true;
}

namespace {

void setPigment(Material& material, const Pigment& pigment) {
    material.pigment = pigment;
    material.pigmentTransform = Transform();
}

}  // namespace

bool TextureParser::startFromDeclared(Material& material) {
    if (const auto declared = takeDeclared<Material>(tokens_))
        material = *declared;
    else if (const auto pigment = takeDeclared<Pigment>(tokens_))
        setPigment(material, *pigment);
    else if (const auto finish = takeDeclared<Finish>(tokens_))
        material.finish = *finish;
    else if (takeDeclared<OpaqueValue>(tokens_))
        addNotSimulated(material.notSimulated, "texture_map");
    else
        return false;
    return true;
}

}  // namespace isoscope
