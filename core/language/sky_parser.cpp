// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/sky_parser.h"

#include "core/language/expressions/declared_value.h"
#include "core/language/objects/transform_parser.h"
#include "core/language/textures/pigment_parser.h"
#include "core/language/textures/texture_parser.h"
#include "core/language/tokens/unknown_name.h"

namespace isoscope {

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
        layer.pigment = PigmentParser(tokens_).parse(draft_.defaultMaterials.back().pigment);
        if (sky.layers.size() < MappedPigment::sizeLimit) sky.layers.push_back(std::move(layer));
        return true;
    }
    if (!tokens_.accept("emission")) return false;
    sky.emission = ExpressionParser(tokens_).parseColor();
    return true;
}

}  // namespace isoscope
