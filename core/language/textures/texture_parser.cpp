// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/textures/texture_parser.h"

#include <algorithm>

#include "core/language/expressions/declared_value.h"
#include "core/language/expressions/expression_parser.h"
#include "core/language/objects/transform_parser.h"
#include "core/language/textures/finish_parser.h"
#include "core/language/textures/image_map_parser.h"
#include "core/language/textures/interior_parser.h"
#include "core/language/textures/map_position.h"
#include "core/language/textures/pigment_parser.h"
#include "core/language/textures/warp_parser.h"
#include "core/language/tokens/nesting_guard.h"
#include "core/language/tokens/povray_refusals.h"
#include "core/language/tokens/unknown_name.h"
#include "core/texture/tables/image_table.h"
#include "core/texture/own_colors.h"
#include "core/texture/surface_needs.h"
#include "core/texture/warped_material.h"

namespace isoscope {

void addNotSimulated(std::vector<std::string>& list, std::string_view keyword) {
    if (std::find(list.begin(), list.end(), keyword) == list.end()) list.emplace_back(keyword);
}

namespace {

/// Whether what is left out of a pigment is not the pattern itself.
bool isSetting(const std::string& word) { return word == "map_type"; }

void addSentences(const Material& material, std::vector<std::string>& sentences) {
    const auto add = [&](const std::string& sentence) { addNotSimulated(sentences, sentence); };
    for (const std::string& keyword : material.notSimulated) add("`" + keyword + "` is not simulated.");
    if (material.map) {
        for (const MappedTexture::Entry& entry : material.map->entries)
            addSentences(entry.material, sentences);
        return;
    }
    for (const std::string& word : notSimulatedIn(material.pigment))
        add(isSetting(word) ? "`" + word + "` is not simulated."
                            : "The pigment pattern `" + word + "` is drawn as one colour.");
    const Finish& finish = material.finish;
    for (const std::string& keyword : finish.notSimulated) add(notSimulatedSentence(keyword));
    for (const Material& layer : material.below) addSentences(layer, sentences);
}

}  // namespace

std::vector<std::string> leftOutSentences(const Material& material) {
    std::vector<std::string> sentences;
    addSentences(material, sentences);
    return sentences;
}

namespace {

/// The material's normal as it looks in the object's coordinates.
NormalPointer movedNormal(const Material& material) {
    if (!material.normal || material.normalTransform.identity()) return material.normal;
    auto normal = std::make_shared<SurfaceNormal>(*material.normal);
    normal->pattern.warps.emplace_back(transformWarp(material.normalTransform));
    return normal;
}

}  // namespace

Material TextureParser::parseTexture() {
    Material material = defaults_;
    if (tokens_.expect("{", "to begin `texture`")) parseBody(material, "}", "texture");
    return material;
}

Material TextureParser::parseTextures() {
    Material material = parseTexture();
    while (tokens_.accept("texture")) material = limited(laidOver(parseTexture(), std::move(material)));
    return material;
}

Material TextureParser::parseInteriorTextures() {
    Material material = parseTexture();
    while (tokens_.accept("interior_texture"))
        material = limited(laidOver(parseTexture(), std::move(material)));
    return material;
}

Material TextureParser::parseMap() {
    TextureParser inner(tokens_, defaults_);
    inner.mapped_.emplace();
    inner.parseTextureMap();
    Material material = defaults_;
    inner.finishMap(material);
    return material;
}

Material TextureParser::limited(Material material) {
    const auto refuse = [&](const std::string& why) {
        tokens_.context().error("too-large", tokens_.lastRange(), why);
        return defaults_;
    };
    if (sizeOf(material) > MappedPigment::sizeLimit || depthOf(material) > MappedPigment::depthLimit)
        return refuse("This texture is made of more than " + std::to_string(MappedPigment::sizeLimit) +
                      " textures, or they are nested more than " + std::to_string(MappedPigment::depthLimit) +
                      " deep.");
    if (shownAtOnce(material) > shownAtOnceLimit)
        return refuse("More than " + std::to_string(shownAtOnceLimit) +
                      " layers and parts of this texture lie over one another.");
    return material;
}

Material TextureParser::parseMaterial() {
    Material material = defaults_;
    std::shared_ptr<const Interior> inside;
    std::optional<Material> inner;
    if (!tokens_.expect("{", "to begin `material`")) return material;
    while (!tokens_.accept("}")) {
        Transform transform;
        const Token token = tokens_.peek();
        if (tokens_.accept("texture")) {
            material = parseTextures();
        } else if (tokens_.accept("interior")) {
            inside = InteriorParser(tokens_).parse();
        } else if (tokens_.accept("interior_texture")) {
            inner = parseInteriorTextures();
        } else if (!startFromDeclared(material) && !parsePart(material)) {
            if (TransformParser(tokens_).parseModifier(transform)) {
                material = moved(std::move(material), transform);
                if (inner) inner = moved(std::move(*inner), transform);
                if (inside) inside = std::make_shared<const Interior>(moved(Interior(*inside), transform));
                continue;
            }
            if (token.kind == TokenKind::end) {
                tokens_.expect("}", "to close `material`");
                break;
            }
            passUnknownItem(tokens_, "material");
        }
    }
    if (inner) material = limited(twoSided(std::move(material), std::move(*inner)));
    if (inside) material.inside = std::move(inside);
    return material;
}

namespace {

/// POV-Ray's rules for the order of a `texture`: `uv_mapping` first; a pattern with nothing but that before
/// it, with a map or list behind it, and no parts of a plain texture beside it.
class TextureOrder {
  public:
    explicit TextureOrder(ParseContext& context) : context_(context) {}

    /// A name of something declared has been read.
    void noteName() { isPlain_ = true; }
    /// An item has been read that began with `word`; `isPattern`: it says which texture is where.
    void note(const Token& word, bool isPattern, MapKind kind) {
        const std::string name(word.text);
        if (word.is("uv_mapping")) {
            if (isPlain_ || pattern_)
                warn(word, "wants `uv_mapping` before other items of a `texture`.",
                     "move it in front of them");
        } else if (isPattern) {
            if (pattern_)
                warn(word, "takes one pattern of textures in a `texture`.", "leave one of them out");
            else if (isPlain_)
                warn(word, "takes no other items before `" + name + "` in a `texture`.",
                     "write them into each of its textures");
            if (!pattern_) pattern_ = word;
            hasMap_ |= word.is("tiles") || word.is("material_map");
        } else if (word.is("pigment") || word.is("normal") || word.is("finish")) {
            if (pattern_)
                warn(word, "takes no `" + name + "` beside a pattern of textures.",
                     "write it into each of the textures");
            isPlain_ = true;
        } else if (word.is("texture_map")) {
            if (!pattern_)
                warn(word, "wants a pattern before a `texture_map`.", "write `bozo` in front of it");
            else if (kind == MapKind::list)
                warn(word, "takes textures alone behind `" + std::string(pattern_->text) + "`.",
                     "write `texture { ... } texture { ... }`");
            hasMap_ = true;
        } else if (word.is("texture")) {
            hasMap_ = true;
        } else if (!word.is("no_bump_scale")) {
            isPlain_ |= !pattern_;
        }
    }
    /// At the end of the block.
    void finish(bool hasEntries) {
        if (pattern_ && !hasMap_ && !hasEntries)
            warn(*pattern_, "wants textures behind `" + std::string(pattern_->text) + "` in a `texture`.",
                 "write a `texture_map` behind it");
    }

  private:
    void warn(const Token& word, const std::string& wants, const std::string& hint) {
        warnOfRefusal(context_, word.range, wants, hint);
    }

    ParseContext& context_;
    bool isPlain_ = false;  ///< something of a texture without a pattern has been read
    bool hasMap_ = false;
    std::optional<Token> pattern_;
};

void setPigment(Material& material, Pigment pigment) {
    material.pigment = std::move(pigment);
    material.pigmentTransform = Transform();
    material.pigmentStated = true;
}

}  // namespace

bool TextureParser::parsePart(Material& material) {
    if (tokens_.accept("pigment")) {
        setPigment(material,
                   PigmentParser(tokens_).parse(moved(material.pigment, material.pigmentTransform)));
        return true;
    }
    if (tokens_.accept("finish")) {
        material.finish = FinishParser(tokens_).parse(material.finish);
        return true;
    }
    if (tokens_.accept("normal")) {
        NormalParser parser(tokens_, movedNormal(defaults_));
        material.normal = parser.parse(movedNormal(material));
        material.normalTransform = Transform();
        for (const std::string& word : parser.leftOut()) addNotSimulated(material.notSimulated, word);
        return true;
    }
    return false;
}

void TextureParser::parseBody(Material& material, std::string_view end, std::string_view keyword) {
    const NestingGuard guard(tokens_);
    if (!guard.ok()) return tokens_.skipBlock();
    bool isFirst = true, namesMayFollow = true;
    TextureOrder order(tokens_.context());
    while (!tokens_.peek().is(end)) {
        const Token word = tokens_.peek();
        // Names of textures stand first, those of pigments, normals and finishes behind nothing but names.
        if (const std::optional<Material> declared = takeDeclared<Material>(tokens_)) {
            material = *declared;
            if (!isFirst) warnOfLateName(tokens_.context(), word, "texture");
            isFirst = false;
            order.noteName();
            continue;
        }
        if (startFromDeclared(material)) {
            if (!namesMayFollow) warnOfLateName(tokens_.context(), word, "part of a texture");
            isFirst = false;
            order.noteName();
            continue;
        }
        if (!word.is("uv_mapping")) isFirst = namesMayFollow = false;
        const bool isPattern =
            reader_.atName() || isPatternLeftOut(word.text) || word.is("tiles") || word.is("material_map");
        if (parseTextureItem(material)) {
            order.note(word, isPattern, mapped_ ? mapped_->kind : MapKind::blend);
            continue;
        }
        const Token token = tokens_.peek();
        if (token.kind == TokenKind::end || token.is("}")) {
            tokens_.expect(end, "to close `" + std::string(keyword) + "`");
            return finishMap(material);
        }
        passUnknownItem(tokens_, keyword, end);
    }
    tokens_.next();
    order.finish(mapped_ && !mapped_->entries.empty());
    finishMap(material);
    applyFlags(material);
}

void TextureParser::applyFlags(Material& material) {
    if (onSurface_) material = laidOnSurface(warped(material, {}));
    if (!unscaledBumps_ || !material.normal) return;
    auto normal = std::make_shared<SurfaceNormal>(*material.normal);
    normal->scaled = false;
    material.normal = std::move(normal);
}

bool TextureParser::parseTextureItem(Material& material) {
    if (tokens_.peek().kind == TokenKind::end) return false;
    if (parsePart(material)) return true;
    if (parseMapItem(material)) return true;
    Transform transform;
    if (!mapped_ && TransformParser(tokens_).parseModifier(transform)) {
        material = moved(std::move(material), transform);
        return true;
    }
    const Token word = tokens_.peek();
    if (word.is("uv_mapping") || word.is("no_bump_scale")) {
        tokens_.next();
        const bool on = ExpressionParser(tokens_).parseBareFlag(word.text);
        (word.is("uv_mapping") ? onSurface_ : unscaledBumps_) = on;
        return true;
    }
    return mapped_ && reader_.parseModifier();
}

bool TextureParser::parseMapItem(Material& material) {
    const Token word = tokens_.peek();
    if (isPatternLeftOut(word.text)) {
        addNotSimulated(material.notSimulated, word.text);
        reader_.skipLeftOut();
        if (!mapped_) mapped_.emplace();
        return true;
    }
    if (reader_.atName()) {
        const bool average = tokens_.accept("average");
        if (!average && !reader_.parseName()) addNotSimulated(material.notSimulated, word.text);
        if (!mapped_) mapped_.emplace();
        const bool opensList = !average && reader_.opensList();
        mapped_->kind = average ? MapKind::average : reader_.countsEntries() ? MapKind::list : MapKind::blend;
        if (opensList) {
            while (addListEntry()) {
            }
            closeTextures("object");
        }
        return true;
    }
    if (tokens_.accept("texture_map")) {
        if (!mapped_) mapped_.emplace();
        parseTextureMap();
        return true;
    }
    if (tokens_.accept("material_map")) {
        parseMaterialMap();
        return true;
    }
    if (tokens_.accept("tiles")) {
        parseTiles();
        return true;
    }
    return mapped_ && mapped_->kind == MapKind::list && addListEntry();
}

bool TextureParser::addListEntry() {
    if (!tokens_.peek().is("texture")) return false;
    reader_.noteEntry(mapped_->entries.size());
    tokens_.next();
    addEntry();
    return true;
}

void TextureParser::addEntry() {
    const double position = static_cast<double>(mapped_->entries.size());
    mapped_->entries.push_back({position, TextureParser(tokens_, defaults_).parseTexture()});
    tokens_.accept(",");
}

/// `tiles { texture { A } tile2 texture { B } }`: a checker of textures.
void TextureParser::parseTiles() {
    mapped_.emplace();
    mapped_->kind = MapKind::list;
    reader_.pattern = Pattern();
    reader_.pattern.kind = PatternKind::checker;
    if (!tokens_.expect("{", "to begin `tiles`")) return;
    while (tokens_.accept("tile2") || tokens_.peek().is("texture"))
        if (tokens_.accept("texture")) addEntry();
    closeTextures("tiles");
    // The first is where the checker has 1.
    if (mapped_->entries.size() == 2) std::swap(mapped_->entries[0].material, mapped_->entries[1].material);
}

/// A picture whose numbers choose among the textures, over and over where there are fewer; the number of
/// textures itself means the last, as in POV-Ray.
void TextureParser::parseMaterialMap() {
    constexpr double numbers = 256;
    mapped_.emplace();
    if (!tokens_.expect("{", "to begin `material_map`")) return;
    ImageMapParser images(tokens_);
    if (!images.parseFile()) return tokens_.skipBlock();
    while (images.parseSetting()) continue;
    while (tokens_.accept("texture")) addEntry();
    closeTextures("material_map");
    const std::shared_ptr<const ImageMap> image = images.read();
    if (!image || mapped_->entries.empty()) return;
    FunctionGraph graph;
    const auto variable = [&](int k) { return Expression(graph, graph.variable(k)); };
    const Expression index = imageValue(image, ImageChannel::index, {variable(0), variable(1), variable(2)});
    const auto count = static_cast<double>(mapped_->entries.size());
    const Expression number =
        select(index - count, index, index.number(count - 1), mod(index, index.number(count)));
    // Patterns keep only fractions; those of 256 are exact, so that just one texture shows.
    reader_.pattern = Pattern();
    reader_.pattern.kind = PatternKind::function;
    reader_.pattern.function = isoscope::finish(std::move(graph), {(number / numbers).node()}, 3);
    for (MappedTexture::Entry& entry : mapped_->entries) entry.position /= numbers;
}

void TextureParser::closeTextures(std::string_view keyword) {
    if (tokens_.accept("}")) return;
    tokens_.context().error(
        "unknown-item", tokens_.peek().range,
        describe(tokens_.peek()) + " is not understood in `" + std::string(keyword) + "`.");
    tokens_.skipBlock();
}

void TextureParser::parseTextureMap() {
    mapped_->entries.clear();
    if (!tokens_.expect("{", "to begin `texture_map`")) return;
    if (const auto declared = takeDeclared<Material>(tokens_))
        if (declared->map) mapped_->entries = declared->map->entries;
    while (tokens_.accept("[")) {
        const double position = parseMapPosition(tokens_, mapped_->kind == MapKind::average);
        Material entry = defaults_;
        TextureParser(tokens_, defaults_).parseBody(entry, "]", "texture_map");
        mapped_->entries.push_back({position, std::move(entry)});
        if (!tokens_.charge(TokenStream::stepsPerItem, tokens_.lastRange())) return;
    }
    if (tokens_.accept("}")) {
        if (mapped_->entries.empty())
            warnOfRefusal(tokens_.context(), tokens_.lastRange(), "wants an entry in a map.",
                          "write `[0 pigment { rgb 0 }]` into it");
        return;
    }
    tokens_.context().error(
        "unexpected-token", tokens_.peek().range,
        "Expected `[` or `}` in `texture_map`, but found " + describe(tokens_.peek()) + ".");
    tokens_.skipBlock();
}

/// The pattern that has been read becomes the material's.
/// As in POV-Ray, a list that is too short goes on with the default texture.
void TextureParser::completeList() {
    std::vector<MappedTexture::Entry>& entries = mapped_->entries;
    const std::size_t length = ownColors(mapped_->pattern.kind).size();
    while (entries.size() < length) entries.push_back({static_cast<double>(entries.size()), defaults_});
}

void TextureParser::finishMap(Material& material) {
    if (!mapped_) return;
    if (mapped_->entries.empty()) {
        mapped_.reset();
        return;
    }
    mapped_->pattern = reader_.pattern;
    if (mapped_->kind == MapKind::list) completeList();
    mapped_->size = 1;
    mapped_->depth = 1;
    for (const MappedTexture::Entry& entry : mapped_->entries) {
        mapped_->size += sizeOf(entry.material);
        mapped_->depth = std::max(mapped_->depth, depthOf(entry.material) + 1);
    }
    material.map = std::make_shared<const MappedTexture>(std::move(*mapped_));
    material.mapTransform = Transform();
    material.below.clear();
    mapped_.reset();
    material = limited(std::move(material));
}

bool TextureParser::startFromDeclared(Material& material) {
    if (const auto declared = takeDeclared<Material>(tokens_)) {
        material = *declared;
    } else if (const auto pigment = takeDeclared<Pigment>(tokens_)) {
        setPigment(material, *pigment);
    } else if (const auto normal = takeDeclared<NormalPointer>(tokens_)) {
        material.normal = *normal;
        material.normalTransform = Transform();
    } else if (const auto finish = takeDeclared<Finish>(tokens_)) {
        material.finish = *finish;
    } else if (const auto opaque = takeDeclared<OpaqueValue>(tokens_)) {
        addNotSimulated(material.notSimulated, opaque->keyword);
    } else {
        return false;
    }
    return true;
}

}  // namespace isoscope
