// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "core/language/expressions/declared_value.h"
#include "core/language/objects/transform_parser.h"
#include "core/language/scene_draft.h"
#include "core/language/statement_description.h"
#include "core/language/textures/pigment_parser.h"
#include "core/language/textures/texture_parser.h"
#include "core/language/tokens/block_words.h"
#include "core/language/tokens/unknown_name.h"
#include "core/texture/surface_needs.h"

namespace isoscope {

namespace {

/// `sky_sphere { ... }`: pigments, transformations, `emission`.
class SkyParser {
  public:
    SkyParser(TokenStream& tokens, const SceneDraft& draft) : tokens_(tokens), draft_(draft) {}

    /// The block with its braces; the word `sky_sphere` has been read. Never null.
    std::shared_ptr<const SkySphere> parse();

  private:
    bool parseItem(SkySphere& sky);

    TokenStream& tokens_;
    const SceneDraft& draft_;
};

std::shared_ptr<const SkySphere> SkyParser::parse() {
    auto sky = std::make_shared<SkySphere>();
    const SourceRange start = tokens_.lastRange();
    if (!tokens_.expect("{", "to begin `sky_sphere`")) return sky;
    while (!tokens_.accept("}")) {
        if (parseItem(*sky)) continue;
        const Token token = tokens_.peek();
        if (token.kind == TokenKind::end) {
            tokens_.expect("}", "to close `sky_sphere`");
            break;
        }
        passUnknownItem(tokens_, "sky_sphere");
    }
    for (const Material& layer : sky->layers)
        for (const std::string& word : notSimulatedIn(layer.pigment))
            reportLeftOut(tokens_.context(), rangeSince(start, tokens_),
                          "The pigment pattern `" + word + "` is drawn as one colour.");
    return sky;
}

bool SkyParser::parseItem(SkySphere& sky) {
    using SkyPointer = std::shared_ptr<const SkySphere>;
    if (const std::optional<SkyPointer> declared = takeDeclared<SkyPointer>(tokens_)) {
        if (*declared) sky = **declared;
        return true;
    }
    Transform transform;
    if (TransformParser(tokens_).parseModifier(transform)) {
        for (Material& layer : sky.layers) layer = moved(std::move(layer), transform);
        return true;
    }
    if (tokens_.accept("pigment")) {
        Material layer;
        layer.pigment = withoutSlopes(PigmentParser(tokens_).parse(draft_.defaultMaterials.back().pigment));
        if (sky.layers.size() < MappedPigment::sizeLimit) sky.layers.push_back(std::move(layer));
        return true;
    }
    if (!tokens_.accept("emission")) return false;
    sky.emission = ExpressionParser(tokens_).parseColor();
    return true;
}

void parse(TokenStream& tokens, SceneDraft& draft) { draft.scene.sky = SkyParser(tokens, draft).parse(); }

std::optional<Value> parseValue(TokenStream& tokens, SceneDraft& draft) {
    return Value{BlockValue("a sky sphere", SkyParser(tokens, draft).parse())};
}

/// The sky may be a declared one, which stays as it was written.
void addMaterials(Scene& scene, std::vector<Material*>& materials) {
    if (!scene.sky) return;
    auto sky = std::make_shared<SkySphere>(*scene.sky);
    for (Material& layer : sky->layers) materials.push_back(&layer);
    scene.sky = std::move(sky);
}

}  // namespace

const StatementDescription statements::skySphere{.word = "sky_sphere",
                                                 .itemWords = {"pigment emission", transformWords},
                                                 .parse = parse,
                                                 .parseValue = parseValue,
                                                 .addMaterials = addMaterials};

}  // namespace isoscope
