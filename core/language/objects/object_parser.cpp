// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/objects/object_parser.h"

#include <algorithm>
#include <array>

#include "core/language/directives/statement_scope.h"
#include "core/language/expressions/declared_value.h"
#include "core/language/expressions/expression_parser.h"
#include "core/language/expressions/object_queries.h"
#include "core/language/light_parser.h"
#include "core/language/objects/isosurface_parser.h"
#include "core/language/objects/shape_reader.h"
#include "core/language/objects/transform_parser.h"
#include "core/language/textures/interior_parser.h"
#include "core/language/textures/texture_parser.h"
#include "core/language/tokens/nesting_guard.h"
#include "core/language/tokens/povray_refusals.h"
#include "core/language/tokens/unknown_name.h"
#include "core/language/tokens/words.h"
#include "core/texture/surface_needs.h"
#include "core/texture/warped_material.h"

namespace isoscope {

namespace {

std::optional<CsgOperation> csgOperation(std::string_view word) {
    if (word == "union" || word == "light_group") return CsgOperation::union_;
    if (word == "merge") return CsgOperation::merge;
    if (word == "intersection") return CsgOperation::intersection;
    if (word == "difference") return CsgOperation::difference;
    return std::nullopt;
}

/// Flags that change nothing here, and the objects of which POV-Ray takes them.
struct FlagOfSome {
    std::string_view word;
    std::array<std::string_view, 9> keywords;  ///< of the objects
    bool wantsValue = false;                   ///< whether it must not stand alone
};
constexpr std::array<FlagOfSome, 3> flagsOfSome{
    {{"sturm", {"blob", "torus", "lathe", "prism", "sor", "cubic", "quartic", "poly", "polynomial"}},
     {"hierarchy", {"blob", "mesh", "mesh2", "height_field"}},
     {"split_union", {"union", "merge", "light_group"}, true}}};

/// Null where the word is none of them.
const FlagOfSome* flagOfSome(std::string_view word) {
    const auto flag = std::ranges::find(flagsOfSome, word, &FlagOfSome::word);
    return flag == flagsOfSome.end() ? nullptr : &*flag;
}

}  // namespace

/// An object statement that is being read.
struct ObjectParser::Statement {
    Token keyword;
    ObjectDescription description;
    std::optional<IsosurfaceParser> isosurface;
    std::vector<std::string> leftOut;  ///< sentences about its texture are added when it is complete
    SourceRange textureRange;
    bool drawn = true;      ///< false when nothing can be shown; the reason has been reported
    bool declared = false;  ///< begins with the name of a declared object, so that it has no parts
    bool excused = false;   ///< its shape was not understood: items that follow may be parts of it
    bool firstPartMissing = false;
    bool onSurface = false;                ///< `uv_mapping` has been said
    std::optional<SourceRange> modifiers;  ///< where the first begins
};

bool ObjectParser::isObject(std::string_view word) {
    return csgOperation(word) || word == "isosurface" || word == "object" || findShapeParser(word) ||
           isUnreadShape(word);
}

ObjectPointer ObjectParser::parse() {
    const Token keyword = tokens_.next();
    const NestingGuard guard(tokens_);
    if (!guard.ok() || isUnreadShape(keyword.text)) return skipNotDrawn(keyword);
    return parseDrawn(keyword);
}

ObjectPointer ObjectParser::skipNotDrawn(const Token& keyword) {
    if (tokens_.accept("{")) tokens_.skipBlock();
    if (isUnreadShape(keyword.text))
        reportLeftOut(tokens_.context(), rangeSince(keyword.range, tokens_),
                      "`" + std::string(keyword.text) + "` is not drawn yet.");
    return nullptr;
}

ObjectPointer ObjectParser::parseDrawn(const Token& keyword) {
    const std::string word(keyword.text);
    if (!tokens_.expect("{", "to begin `" + word + "`")) return nullptr;
    const StatementScope scope(tokens_.context());
    Statement statement;
    statement.keyword = keyword;
    statement.description.keyword = word;
    statement.description.range = keyword.range;
    parseContents(statement);
    while (!tokens_.peek().is("}")) {
        if (parseModifier(statement)) continue;
        if (tokens_.peek().kind == TokenKind::end) {
            tokens_.expect("}", "to close `" + word + "`");
            if (tokens_.cutOff()) return nullptr;
            if (statement.isosurface) statement.isosurface->excuse();
            return finish(statement);
        }
        if (!statement.excused)
            passUnknownItem(tokens_, word);
        else if (!closeUnclosed(tokens_, word))
            skipUnknownItem(tokens_, word);
        if (statement.isosurface) statement.isosurface->excuse();
    }
    tokens_.next();
    return finish(statement);
}

void ObjectParser::parseContents(Statement& statement) {
    const std::string_view word = statement.keyword.text;
    if (word == "object" || word == "looks_like" || word == "projected_through")
        return parseObjectContents(statement);
    // A group of lights has parts only.
    if (word != "light_group" && startFromDeclared(statement)) return;
    if (word == "isosurface")
        statement.isosurface.emplace(tokens_);
    else if (const ShapeParser* parser = findShapeParser(word))
        parseShape(statement, *parser);
    else
        parseParts(statement);
}

void ObjectParser::parseShape(Statement& statement, const ShapeParser& parser) {
    ShapeReader reader(tokens_, draft_, statement.keyword);
    ShapePointer shape = parser.parse(reader);
    statement.excused = reader.failed();
    if (!reader.finite())
        tokens_.context().error("bad-value", statement.keyword.range,
                                "The numbers of this `" + reader.keyword() + "` are not all finite.");
    if (!reader.textures.empty())
        statement.description.partTextures =
            std::make_shared<const std::vector<Material>>(std::move(reader.textures));
    if (reader.finite() && !reader.failed() && shape)
        statement.description.shape = std::move(shape);
    else
        statement.drawn = false;
}

void ObjectParser::parseParts(Statement& statement) {
    statement.description.operation = *csgOperation(statement.keyword.text);
    while (parsePart(statement)) continue;
}

bool ObjectParser::parsePart(Statement& statement) {
    const Token token = tokens_.peek();
    if (token.is("light_source")) {
        tokens_.next();
        addLight(statement);
        return true;
    }
    if (takeLight(statement)) return true;
    if (token.kind == TokenKind::word && isObject(token.text))
        addPart(statement, parse());
    else if (const std::optional<ObjectPointer> named = parseName())
        addPart(statement, *named);
    else
        return false;
    return true;
}

void ObjectParser::addPart(Statement& statement, const ObjectPointer& part) {
    ObjectDescription& description = statement.description;
    if (part) {
        if (grow(statement, *part)) description.parts.push_back(part);
        return;
    }
    const bool first = description.parts.empty() && !statement.firstPartMissing;
    statement.firstPartMissing |= first && description.operation == CsgOperation::difference;
}

std::optional<ObjectPointer> ObjectParser::parseName() {
    Statement statement;
    statement.keyword = tokens_.peek();
    statement.description.keyword = "object";
    statement.description.range = statement.keyword.range;
    if (!startFromDeclared(statement)) return std::nullopt;
    return finish(statement);
}

void ObjectParser::addLight(Statement& statement) {
    LightParser parser(tokens_, &draft_);
    statement.description.lights.push_back(parser.parse());
    if (parser.looks() && grow(statement, *parser.looks()))
        statement.description.parts.push_back(parser.looks());
}

bool ObjectParser::grow(Statement& statement, const ObjectDescription& part) {
    ObjectDescription& description = statement.description;
    description.shapeCount += part.shapeCount;
    description.depth = std::max(description.depth, part.depth + 1);
    if (description.shapeCount <= ObjectDescription::shapeLimit &&
        description.depth <= ObjectDescription::depthLimit)
        return true;
    if (statement.drawn)
        tokens_.context().error("too-large", statement.keyword.range,
                                "This object has more than " + std::to_string(ObjectDescription::shapeLimit) +
                                    " parts, or is nested more than " +
                                    std::to_string(ObjectDescription::depthLimit) + " deep.");
    statement.drawn = false;
    return false;
}

void ObjectParser::parseObjectContents(Statement& statement) {
    const Token token = tokens_.peek();
    if (token.kind == TokenKind::word && isObject(token.text)) {
        if (const ObjectPointer inner = parse())
            take(statement, inner);
        else
            statement.drawn = false;
        return;
    }
    if (token.is("light_source")) {
        tokens_.next();
        addLight(statement);
        return;
    }
    if (startFromDeclared(statement)) return;
    statement.drawn = false;
    if (const auto opaque = takeDeclared<OpaqueValue>(tokens_)) {
        reportLeftOut(tokens_.context(), token.range, "`" + opaque->keyword + "` is not drawn yet.");
        return;
    }
    const Value* value = token.kind == TokenKind::word ? tokens_.context().symbols.find(token.text) : nullptr;
    if (token.kind == TokenKind::word && !isReservedWord(token.text)) tokens_.next();
    if (value)
        tokens_.context().error(
            "not-an-object", token.range,
            "`" + std::string(token.text) + "` is " + kindOf(*value) + ", not an object.");
    else
        tokens_.context().error(
            "unknown-name", token.range,
            "Expected an object or the name of a declared one here, but found " + describe(token) + ".");
}

bool ObjectParser::startFromDeclared(Statement& statement) {
    const std::optional<ObjectPointer> object = takeDeclared<ObjectPointer>(tokens_);
    if (object && *object)
        take(statement, *object);
    else if (object)
        statement.drawn = false;
    else if (!takeLight(statement))
        return false;
    statement.declared = true;
    return true;
}

bool ObjectParser::takeLight(Statement& statement) {
    const auto light = takeDeclared<LightSource>(tokens_);
    if (!light) return false;
    if (tokens_.charge(TokenStream::stepsPerItem, tokens_.lastRange()))
        statement.description.lights.push_back(*light);
    return true;
}

void ObjectParser::take(Statement& statement, const ObjectPointer& object) {
    const SourceRange range = statement.description.range;
    constexpr std::size_t partsPerStep = 64;
    tokens_.charge(object->shapeCount / partsPerStep, range);
    statement.description = *object;
    statement.description.range = range;
}

bool ObjectParser::parseModifier(Statement& statement) {
    if (statement.isosurface && statement.isosurface->parseItem(statement.modifiers)) return true;
    const Token word = tokens_.peek();
    if (parseTransform(statement) || parseTexture(statement) || parseInterior(statement) ||
        parseFlag(statement) || parseWrapping(statement) || parseIgnored(statement)) {
        if (!statement.modifiers) statement.modifiers = word.range;
        return true;
    }
    if (statement.declared || !csgOperation(statement.keyword.text) || !parsePart(statement)) return false;
    if (statement.modifiers)
        warnOfLateItem(tokens_, *statement.modifiers, word,
                       "wants the objects of a `" + std::string(statement.keyword.text) +
                           "` before its textures, transformations and other modifiers.");
    return true;
}

bool ObjectParser::parseTransform(Statement& statement) {
    Transform transform;
    if (!TransformParser(tokens_).parseModifier(transform)) return false;
    ObjectDescription& description = statement.description;
    description.transform = description.transform.then(transform);
    for (std::optional<Material>* material : {&description.material, &description.interiorTexture})
        if (*material) *material = moved(std::move(**material), transform);
    if (description.interior && !description.interior->media.empty())
        description.interior =
            std::make_shared<const Interior>(moved(Interior(*description.interior), transform));
    for (Wrapping& wrapping : description.wrappings)
        for (ClippingObject& object : wrapping.objects) object.transform = object.transform.then(transform);
    for (LightSource& light : description.lights) light = transformed(light, transform);
    return true;
}

bool ObjectParser::parseTexture(Statement& statement) {
    const Token word = tokens_.peek();
    ObjectDescription& description = statement.description;
    TextureParser textures(tokens_, draft_.defaultMaterials.back());
    if (tokens_.accept("texture")) {
        const bool layered = description.hasTexture && description.material;
        Material material = textures.parseTextures();
        description.material =
            layered ? textures.limited(laidOver(std::move(material), std::move(*description.material)))
                    : std::move(material);
        description.hasTexture = true;
    } else if (tokens_.accept("interior_texture")) {
        description.interiorTexture = textures.parseInteriorTextures();
        return true;
    } else if (tokens_.accept("material")) {
        description.material = textures.parseMaterial();
        description.hasTexture = true;
        if (description.material->inside) description.interior = description.material->inside;
    } else {
        Material material = description.material.value_or(draft_.defaultMaterials.back());
        if (!textures.parsePart(material)) return false;
        description.material = material;
    }
    if (statement.onSurface) description.material = laidOnSurface(warped(*description.material, {}));
    statement.textureRange = rangeSince(word.range, tokens_);
    const NormalPointer& normal = description.material->normal;
    if (normal && normal->flat && !word.is("pigment") && !word.is("finish"))
        warnOfRefusal(tokens_.context(), statement.textureRange,
                      "wants a pattern or a declared normal in a `normal`.", "write `bumps 0.5` into it");
    return true;
}

bool ObjectParser::parseInterior(Statement& statement) {
    if (!tokens_.accept("interior")) return false;
    statement.description.interior = InteriorParser(tokens_).parse();
    return true;
}

bool ObjectParser::parseFlag(Statement& statement) {
    ObjectDescription& description = statement.description;
    const auto parseOn = [&] {
        ExpressionParser expressions(tokens_);
        return !expressions.atExpression() || expressions.parseBool();
    };
    if (tokens_.accept("no_shadow"))
        description.castsShadow = !ExpressionParser(tokens_).parseBareFlag("no_shadow");
    else if (tokens_.accept("no_image"))
        description.visible = !parseOn();
    else if (tokens_.accept("no_reflection"))
        description.reflected = !parseOn();
    else if (tokens_.accept("hollow"))
        description.hollow = parseOn();
    else if (tokens_.accept("double_illuminate"))
        description.doubleIlluminate = parseOn();
    else if (tokens_.accept("no_radiosity"))
        parseOn();
    else if (const FlagOfSome* flag = flagOfSome(tokens_.peek().text)) {
        const Token word = tokens_.next();
        if (flag->wantsValue && !ExpressionParser(tokens_).atExpression())
            warnOfRefusal(tokens_.context(), word.range,
                          "wants a number behind `" + std::string(word.text) + "`.", "write `on` behind it");
        parseOn();
        // Of an `object`, what it holds.
        const std::string& object = statement.description.keyword;
        if (statement.drawn && std::ranges::find(flag->keywords, object) == flag->keywords.end())
            warnOfRefusal(tokens_.context(), word.range,
                          "does not take `" + std::string(word.text) + "` in `" + object + "`.",
                          "leave it out");
    } else if (tokens_.accept("global_lights"))
        description.globalLights = parseOn();
    else if (const Token word = tokens_.peek(); tokens_.accept("uv_mapping")) {
        const std::string wants = "wants `uv_mapping` before the texture of an object.";
        if (description.material && statement.modifiers)
            warnOfLateItem(tokens_, *statement.modifiers, word, wants);
        else if (description.material)
            warnOfRefusal(tokens_.context(), word.range, wants, "declare the object without a texture");
        statement.onSurface = ExpressionParser(tokens_).parseBareFlag("uv_mapping");
        if (statement.onSurface && description.material)
            description.material = laidOnSurface(warped(*description.material, {}));
        description.partsOnSurface |= statement.onSurface;
    } else if (tokens_.accept("cutaway_textures")) {
        const SourceRange range = tokens_.lastRange();
        const bool cuts = description.operation == CsgOperation::intersection ||
                          description.operation == CsgOperation::difference;
        if (!cuts)
            tokens_.context().error("unexpected-token", range,
                                    "`cutaway_textures` stands in an `intersection` or `difference` only.");
        description.cutawayTextures = ExpressionParser(tokens_).parseBareFlag("cutaway_textures");
    } else
        return false;
    return true;
}

bool ObjectParser::parseWrapping(Statement& statement) {
    const Token word = tokens_.peek();
    const WrappingModifier* modifier =
        word.kind == TokenKind::word ? findWrappingModifier(word.text) : nullptr;
    if (!modifier) return false;
    tokens_.next();
    WrappingReader reader{tokens_, statement.description, [&] {
                              std::optional<ObjectPointer> object = parseClippingObject();
                              if (object && *object && !grow(statement, **object)) object->reset();
                              return object;
                          }};
    modifier->read(reader, statement.description.wrapping(*modifier));
    return true;
}

std::optional<ObjectPointer> ObjectParser::parseClippingObject() {
    // Bare names may stand here, without `object`.
    if (const std::optional<ObjectPointer> declared = takeDeclared<ObjectPointer>(tokens_)) return declared;
    if (tokens_.peek().kind == TokenKind::word && isObject(tokens_.peek().text)) return parse();
    return std::nullopt;
}

bool ObjectParser::parseIgnored(Statement&) {
    static constexpr std::array<const char*, 3> blocks{"photons", "uv_vectors", "radiosity"};
    const Token word = tokens_.peek();
    for (const char* block : blocks)
        if (tokens_.accept(block)) {
            if (tokens_.accept("{"))
                tokens_.skipBlock();
            else if (ExpressionParser(tokens_).atExpression())
                ExpressionParser(tokens_).parseValue();
            reportLeftOut(tokens_.context(), word.range,
                          "`" + std::string(word.text) + "` is not simulated.");
            return true;
        }
    return false;
}

ObjectPointer ObjectParser::finish(Statement& statement) {
    ObjectDescription& description = statement.description;
    description.range = rangeSince(statement.keyword.range, tokens_);
    const SourceLibrary& sources = tokens_.context().sources;
    if (description.range.file < sources.size())
        description.line = sources[description.range.file].position(description.range.begin).line;
    if (statement.isosurface) statement.isosurface->finish(description, statement.keyword.range);
    if (description.material && statement.textureRange.end > 0) {
        for (const std::string& sentence : leftOutSentences(*description.material))
            reportLeftOut(tokens_.context(), statement.textureRange, sentence);
        if (statement.keyword.text == "parametric" && onSurface(*description.material))
            reportLeftOut(tokens_.context(), statement.textureRange,
                          "`uv_mapping` looks otherwise than in POV-Ray here: on a `parametric` it takes x "
                          "and y in place of u "
                          "and v.");
    }
    if (description.interiorTexture && !description.material && !statement.excused)
        warnOfRefusal(tokens_.context(), statement.keyword.range,
                      "wants a texture beside an `interior_texture`.", "give the object a `texture`");
    if (description.interiorTexture)
        for (const std::string& sentence : leftOutSentences(*description.interiorTexture))
            reportLeftOut(tokens_.context(), description.range, sentence);
    if (description.partTextures)
        for (const Material& texture : *description.partTextures)
            for (const std::string& sentence : leftOutSentences(texture))
                reportLeftOut(tokens_.context(), description.range, sentence);
    // What is inside is found once, not for each value of a slider.
    if (description.cutawayTextures) markStructural(tokens_.context(), description);
    // POV-Ray 3.7 draws their cuts black, but for a few points.
    if (description.operation != CsgOperation::union_ &&
        std::any_of(description.parts.begin(), description.parts.end(),
                    [](const ObjectPointer& part) { return part->cutawayTextures; }))
        reportLeftOut(tokens_.context(), description.range,
                      "`cutaway_textures` of a part is not simulated; its cuts have the default texture.");
    // Each level of parts is made once more, to ask it.
    constexpr std::size_t cutawayLimit = 1'000'000;
    if (description.cutawayTextures &&
        description.shapeCount * static_cast<std::size_t>(description.depth) > cutawayLimit) {
        description.cutawayTextures = false;
        reportLeftOut(tokens_.context(), description.range,
                      "`cutaway_textures` is not simulated on objects of so many shapes.");
    }
    if (statement.firstPartMissing) {
        reportLeftOut(tokens_.context(), description.range,
                      "The difference is not drawn, because the object to cut from is left out.");
        return nullptr;
    }
    const bool empty = !description.shape && description.parts.empty() && description.lights.empty();
    if (!statement.drawn || empty) return nullptr;
    return std::make_shared<const ObjectDescription>(std::move(description));
}

}  // namespace isoscope
