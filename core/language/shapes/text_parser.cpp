// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "core/language/directives/asset_file.h"
#include "core/language/expressions/expression_parser.h"
#include "core/language/objects/shape_parser.h"
#include "core/language/objects/shape_reader.h"
#include "core/shapes/combined/csg.h"
#include "core/shapes/combined/placed_shape.h"
#include "core/shapes/solids/font_file.h"
#include "core/shapes/solids/prism.h"

namespace isoscope {

namespace {

constexpr std::size_t lengthLimit = 10'000;

/// The characters of UTF-8 text; bytes that are none count as Latin-1.
std::u32string decoded(const std::string& text) {
    std::u32string characters;
    for (std::size_t i = 0; i < text.size();) {
        const auto byte = static_cast<unsigned char>(text[i]);
        const int more = byte >= 0xf0 ? 3 : byte >= 0xe0 ? 2 : byte >= 0xc2 ? 1 : 0;
        char32_t character = more == 0 ? byte : byte & (0x3f >> more);
        bool valid = i + static_cast<std::size_t>(more) < text.size();
        for (int k = 1; valid && k <= more; ++k) {
            const auto next = static_cast<unsigned char>(text[i + static_cast<std::size_t>(k)]);
            valid = (next & 0xc0) == 0x80;
            character = character << 6 | (next & 0x3f);
        }
        characters.push_back(valid ? character : byte);
        i += valid ? static_cast<std::size_t>(more) + 1 : 1;
    }
    return characters;
}

/// From the prism's x-z plane and height to the text's x-y plane and depth.
Transform upright(const glm::dvec3& origin) {
    glm::dmat4 matrix(0);
    matrix[0] = {1, 0, 0, 0};
    matrix[1] = {0, 0, 1, 0};
    matrix[2] = {0, 1, 0, 0};
    matrix[3] = {origin, 1};
    return Transform::matrix(matrix);
}

ShapePointer assembled(const FontFile& font, const std::u32string& text, double thickness,
                       const glm::dvec3& offset) {
    std::vector<ShapePointer> glyphs;
    glm::dvec3 place(0);
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (i > 0) place.x += font.kerning(text[i - 1], text[i]);
        FontFile::Glyph glyph = font.glyph(text[i]);
        // POV-Ray lets the outline of the first letter begin at 0.
        if (i == 0) place.x -= glyph.bearing;
        const PrismStyle style{.outwardCaps = true, .statedLow = glyph.low, .statedHigh = glyph.high};
        if (!glyph.outline.empty())
            glyphs.push_back(std::make_shared<PlacedShape>(
                std::make_shared<Prism>(std::move(glyph.outline), 0, thickness, style), upright(place)));
        place += offset;
        place.x += glyph.advance;
    }
    if (glyphs.empty()) return nullptr;
    // POV-Ray turns letters by a thousandth of a degree about each axis.
    return std::make_shared<PlacedShape>(std::make_shared<Csg>(CsgOperation::union_, std::move(glyphs)),
                                         Transform::rotation(glm::dvec3(0.001)));
}

/// The font behind `internal N`: POV-Ray has its own fonts built in.
std::string internalFont(double number) {
    static constexpr std::array<const char*, 4> names{"timrom.ttf", "cyrvetic.ttf", "crystal.ttf",
                                                      "povlogo.ttf"};
    if (!(number > 1)) return names[0];
    return names[static_cast<std::size_t>(std::min(number, 4.0)) - 1];
}

ShapePointer parseText(ShapeReader& reader) {
    TokenStream& tokens = reader.tokens();
    const bool internal = tokens.accept("internal");
    if (!internal && !tokens.accept("ttf")) {
        reader.fail(tokens.peek().range,
                    "Expected `ttf` or `internal` and a font, but found " + describe(tokens.peek()) + ".");
        return nullptr;
    }
    const SourceRange start = tokens.peek().range;
    const std::string fontName = internal ? internalFont(ExpressionParser(tokens).parseFloat())
                                          : ExpressionParser(tokens).parseString();
    const SourceRange fontRange = rangeSince(start, tokens);
    tokens.accept(",");
    const std::string text = ExpressionParser(tokens).parseString();
    const SourceRange textRange = tokens.lastRange();
    tokens.accept(",");
    const double thickness = reader.number("thickness");
    const glm::dvec3 offset = reader.vector("offset");
    if (text.size() > lengthLimit) reader.fail(textRange, "A text has at most 10 000 characters.");
    AssetFile file = findAsset(tokens.context(), fontName, start);
    if (!file && file.problem.empty()) file = findAsset(tokens.context(), fontName + ".ttf", start);
    const std::unique_ptr<FontFile> font = file ? FontFile::open(*file) : nullptr;
    if (!font)
        reader.fail(
            fontRange,
            file ? "\"" + fontName + "\" is no TrueType font."
                 : file.whyNot("The font \"" + fontName +
                               "\" was not found beside the scene or in the library paths."),
            file ? ""
            : !file.problem.empty()
                ? file.hint
                : "the fonts of POV-Ray are in its include folder, which can be added to the library paths");
    if (reader.failed() || !reader.finite()) return nullptr;
    ShapePointer shape = assembled(*font, decoded(text), thickness, offset);
    if (!shape) reader.warn(textRange, "This text has nothing to show.");
    return shape;
}

}  // namespace

std::span<const ShapeParser> textParser() {
    static constexpr std::array parsers{
        ShapeParser{.keyword = "text", .parse = parseText, .words = "ttf internal"},
    };
    return parsers;
}

}  // namespace isoscope
