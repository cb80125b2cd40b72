// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <glm/geometric.hpp>

#include "core/language/expressions/declared_value.h"
#include "core/language/scene_draft.h"
#include "core/language/statement_description.h"
#include "core/language/textures/pigment_parser.h"
#include "core/language/tokens/povray_refusals.h"
#include "core/language/tokens/unknown_name.h"

namespace isoscope {

namespace {

/// `rainbow { ... }`.
class RainbowParser {
  public:
    explicit RainbowParser(TokenStream& tokens) : tokens_(tokens) {}

    /// The block with its braces; the word `rainbow` has been read. Nothing when it cannot be drawn, which
    /// has been reported.
    std::optional<Rainbow> parse();

  private:
    bool parseItem();
    bool parseNumberItem();

    TokenStream& tokens_;
    Rainbow rainbow_;
    bool hasColors_ = false;
};

std::optional<Rainbow> RainbowParser::parse() {
    // Where the text says nothing the arc is whole.
    rainbow_.arcAngle = rainbow_.falloffAngle = 360;
    rainbow_.direction = {};
    const SourceRange start = tokens_.lastRange();
    tokens_.charge(TokenStream::stepsPerItem, start);
    if (!tokens_.expect("{", "to begin `rainbow`")) return std::nullopt;
    while (!tokens_.accept("}")) {
        if (parseItem()) continue;
        const Token token = tokens_.peek();
        if (token.kind == TokenKind::end) {
            tokens_.expect("}", "to close `rainbow`");
            return std::nullopt;
        }
        passUnknownItem(tokens_, "rainbow");
    }
    const SourceLibrary& sources = tokens_.context().sources;
    if (start.file < sources.size()) rainbow_.line = sources[start.file].position(start.begin).line;
    const char* missing = !hasColors_                                               ? "a `color_map`"
                          : !(rainbow_.width > 0)                                   ? "a `width`"
                          : !(rainbow_.distance > 0)                                ? "a `distance`"
                          : !(glm::dot(rainbow_.direction, rainbow_.direction) > 0) ? "a `direction`"
                                                                                    : nullptr;
    if (!missing) {
        if (glm::cross(rainbow_.direction, rainbow_.up) == glm::dvec3(0))
            warnOfRefusal(tokens_.context(), rangeSince(start, tokens_),
                          "wants an `up` that is not along the `direction` of a `rainbow`.",
                          "turn one of them");
        return rainbow_;
    }
    tokens_.context().error("bad-rainbow", rangeSince(start, tokens_),
                            std::string("A rainbow needs ") + missing + ".");
    return std::nullopt;
}

bool RainbowParser::parseItem() {
    if (const std::optional<Rainbow> declared = takeDeclared<Rainbow>(tokens_)) {
        rainbow_ = *declared;
        hasColors_ = true;
        return true;
    }
    const Token word = tokens_.peek();
    ExpressionParser expressions(tokens_);
    if (tokens_.accept("direction")) {
        rainbow_.direction = expressions.parseVector();
    } else if (tokens_.accept("up")) {
        rainbow_.up = expressions.parseVector();
    } else if (PigmentParser::isMap(word.text)) {
        tokens_.next();
        const Pigment map = PigmentParser(tokens_).parseMap(word.text);
        rainbow_.colors.pigment = map;
        if (const auto* mapped = std::get_if<std::shared_ptr<const MappedPigment>>(&map)) {
            auto across = std::make_shared<MappedPigment>(**mapped);
            across->pattern = Pattern();
            across->pattern.kind = PatternKind::gradient;
            rainbow_.colors.pigment = std::move(across);
        }
        hasColors_ = true;
    } else if (!parseNumberItem()) {
        return false;
    }
    return true;
}

bool RainbowParser::parseNumberItem() {
    struct Entry {
        const char* word;
        double Rainbow::*member;
    };
    static constexpr std::array<Entry, 6> entries{{{"angle", &Rainbow::angle},
                                                   {"width", &Rainbow::width},
                                                   {"distance", &Rainbow::distance},
                                                   {"jitter", &Rainbow::jitter},
                                                   {"arc_angle", &Rainbow::arcAngle},
                                                   {"falloff_angle", &Rainbow::falloffAngle}}};
    for (const Entry& entry : entries)
        if (tokens_.accept(entry.word)) {
            rainbow_.*entry.member = ExpressionParser(tokens_).parseFloat();
            return true;
        }
    return false;
}

void parse(TokenStream& tokens, SceneDraft& draft) {
    if (std::optional<Rainbow> rainbow = RainbowParser(tokens).parse())
        draft.scene.rainbows.push_back(std::move(*rainbow));
}

std::optional<Value> parseValue(TokenStream& tokens, SceneDraft&) {
    if (std::optional<Rainbow> rainbow = RainbowParser(tokens).parse())
        return Value{BlockValue("a rainbow", std::move(*rainbow))};
    return Value{OpaqueValue{"rainbow"}};
}

void addMaterials(Scene& scene, std::vector<Material*>& materials) {
    for (Rainbow& rainbow : scene.rainbows) materials.push_back(&rainbow.colors);
}

}  // namespace

const StatementDescription statements::rainbow{
    .word = "rainbow",
    .itemWords = {"direction angle width distance jitter arc_angle falloff_angle up color_map"},
    .parse = parse,
    .parseValue = parseValue,
    .addMaterials = addMaterials};

}  // namespace isoscope
