// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "core/language/objects/shape_parser.h"
#include "core/language/objects/shape_reader.h"
#include "core/language/objects/transform_parser.h"
#include "core/language/textures/texture_parser.h"
#include "core/language/tokens/povray_refusals.h"
#include "core/shapes/solids/blob.h"

namespace isoscope {

namespace {

/// Each component is looked at along every line that meets its sphere.
constexpr std::size_t partLimit = 20'000;

/// The items of `blob { ... }`.
class BlobReader {
  public:
    explicit BlobReader(ShapeReader& reader) : reader_(reader), tokens_(reader.tokens()) {
        // Behind a radius, in front of the word `strength`.
        reader_.allowLastCommas();
    }

    std::vector<BlobComponent> components;
    double threshold = 1;

    bool parseItem() {
        bool ignored = false;
        if (tokens_.accept("threshold"))
            parseThreshold();
        else if (tokens_.accept("sphere"))
            parseComponent(false);
        else if (tokens_.accept("cylinder"))
            parseComponent(true);
        else if (tokens_.accept("component"))
            parseOldComponent();
        else
            return reader_.flag("hierarchy", ignored) || reader_.flag("sturm", ignored);
        return true;
    }

  private:
    void parseThreshold() {
        threshold = reader_.number("threshold");
        warnOfLastComma(tokens_);
        if (!(threshold > 0))
            reader_.fail(reader_.range(), "The threshold of a blob must be greater than 0.");
    }

    double parseRadius() {
        const double radius = reader_.number("radius");
        if (radius == 0) reader_.fail(reader_.range(), "The radius of a blob's component must not be 0.");
        return radius;
    }

    double parseStrength() {
        const double strength = reader_.number("strength");
        if (strength == 0) reader_.warn(reader_.range(), "A component of strength 0 adds nothing to a blob.");
        return strength;
    }

    void parseComponent(bool cylinder) {
        const std::string word = cylinder ? "cylinder" : "sphere";
        if (!reader_.opens(word)) return;
        BlobComponent component;
        component.from = reader_.vector(cylinder ? "base" : "center");
        component.to = cylinder ? reader_.vector("cap") : component.from;
        component.radius = parseRadius();
        tokens_.accept("strength");
        component.strength = parseStrength();
        warnOfLastComma(tokens_);
        while (parseModifier(component)) continue;
        if (!tokens_.accept("}")) {
            reader_.fail(tokens_.peek().range,
                         describe(tokens_.peek()) + " is not understood in a component of a blob.",
                         "a component has a place, a radius, a strength, a texture and transformations");
            tokens_.skipBlock();
        }
        add(component);
    }

    void add(const BlobComponent& component) {
        if (components.size() < partLimit) {
            components.push_back(component);
        } else if (!full_) {
            full_ = true;
            reader_.fail(reader_.range(), "A blob has at most " + std::to_string(partLimit) + " components.",
                         "several blobs in a union may have more");
        }
    }

    bool parseModifier(BlobComponent& component) {
        Transform transform;
        std::vector<Material>& materials = reader_.textures;
        if (TransformParser(tokens_).parseModifier(transform)) {
            component.transform = component.transform.then(transform);
            if (component.texture > 0)
                materials[component.texture - 1] =
                    moved(std::move(materials[component.texture - 1]), transform);
            return true;
        }
        TextureParser textures(tokens_, reader_.draft().defaultMaterials.back());
        Material material = component.texture > 0 ? materials[component.texture - 1]
                                                  : reader_.draft().defaultMaterials.back();
        if (tokens_.accept("texture"))
            material = textures.parseTextures();
        else if (!textures.parsePart(material))
            return false;
        if (component.texture == 0) {
            materials.emplace_back();
            component.texture = materials.size();
        }
        materials[component.texture - 1] = std::move(material);
        return true;
    }

    void parseOldComponent() {
        BlobComponent component;
        component.strength = parseStrength();
        component.radius = parseRadius();
        component.from = component.to = reader_.vector("center");
        add(component);
    }

    ShapeReader& reader_;
    TokenStream& tokens_;
    bool full_ = false;
};

ShapePointer parseBlob(ShapeReader& reader) {
    BlobReader blob(reader);
    while (blob.parseItem()) continue;
    if (blob.components.empty() && !reader.failed())
        reader.fail(reader.keywordRange(), "A blob needs at least one component.",
                    "write `sphere { <0, 0, 0>, 1, 1 }` into it");
    if (reader.failed() || !reader.finite()) return nullptr;
    return std::make_shared<Blob>(std::move(blob.components), blob.threshold);
}

}  // namespace

std::span<const ShapeParser> blobParser() {
    static constexpr std::array parsers{
        ShapeParser{.keyword = "blob",
                    .parse = parseBlob,
                    .words = "sphere cylinder component threshold",
                    .ignoresOwnBounds = true},
    };
    return parsers;
}

}  // namespace isoscope
