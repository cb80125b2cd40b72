// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/solids/font_file.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H
#include FT_TRUETYPE_TABLES_H
#include FT_TRUETYPE_TAGS_H

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace isoscope {

struct FontFile::Face {
    FT_Library library = nullptr;
    FT_Face face = nullptr;

    ~Face() {
        if (face) FT_Done_Face(face);
        if (library) FT_Done_FreeType(library);
    }
};

namespace {

/// Collects an outline in font units.
struct Pen {
    std::vector<CurvePiece> pieces;
    glm::dvec2 at{0};
    glm::dvec2 start{0};
    double scale = 1;
    double shift = 0;  ///< to the right, in units of the line height

    glm::dvec2 place(const FT_Vector* v) const {
        return glm::dvec2(static_cast<double>(v->x), static_cast<double>(v->y)) * scale +
               glm::dvec2(shift, 0);
    }
    void lineTo(const glm::dvec2& to) {
        if (to != at) pieces.push_back({{at, to - at}, 1});
        at = to;
    }
    void close() { lineTo(start); }
};

Pen& penOf(void* user) { return *static_cast<Pen*>(user); }

int moveTo(const FT_Vector* to, void* user) {
    Pen& pen = penOf(user);
    pen.close();
    pen.at = pen.start = pen.place(to);
    return 0;
}

int lineTo(const FT_Vector* to, void* user) {
    penOf(user).lineTo(penOf(user).place(to));
    return 0;
}

int conicTo(const FT_Vector* control, const FT_Vector* to, void* user) {
    Pen& pen = penOf(user);
    const glm::dvec2 a = pen.at, b = pen.place(control), c = pen.place(to);
    pen.pieces.push_back({{a, 2.0 * (b - a), a - 2.0 * b + c}, 2});
    pen.at = c;
    return 0;
}

int cubicTo(const FT_Vector* control1, const FT_Vector* control2, const FT_Vector* to, void* user) {
    Pen& pen = penOf(user);
    const glm::dvec2 a = pen.at, b = pen.place(control1), c = pen.place(control2), d = pen.place(to);
    pen.pieces.push_back({{a, 3.0 * (b - a), 3.0 * (a - 2.0 * b + c), d - a + 3.0 * (b - c)}, 3});
    pen.at = d;
    return 0;
}

/// The bytes of a table of the font from `offset` on, `count` of them; empty when there are not so many.
std::vector<FT_Byte> tableBytes(FT_Face face, FT_ULong tag, FT_ULong offset, FT_ULong count) {
    FT_ULong size = 0;
    if (FT_Load_Sfnt_Table(face, tag, 0, nullptr, &size) != 0 || offset > size || count > size - offset)
        return {};
    std::vector<FT_Byte> bytes(count);
    if (FT_Load_Sfnt_Table(face, tag, static_cast<FT_Long>(offset), bytes.data(), &count) != 0) return {};
    return bytes;
}

/// xMin, yMin, xMax and yMax in the header of a TrueType glyph, which FreeType does not tell.
std::optional<std::array<double, 4>> statedBox(FT_Face face, FT_UInt glyph) {
    const auto* head = static_cast<const TT_Header*>(FT_Get_Sfnt_Table(face, FT_SFNT_HEAD));
    if (!head) return {};
    const bool wide = head->Index_To_Loc_Format != 0;
    const FT_ULong width = wide ? 4 : 2;
    const std::vector<FT_Byte> place = tableBytes(face, TTAG_loca, glyph * width, width);
    FT_ULong offset = 0;
    for (const FT_Byte byte : place) offset = offset << 8 | byte;
    const std::vector<FT_Byte> header = tableBytes(face, TTAG_glyf, wide ? offset : 2 * offset, 10);
    if (place.empty() || header.empty()) return {};
    std::array<double, 4> box;
    for (std::size_t k = 0; k < 4; ++k)
        box[k] = static_cast<std::int16_t>(header[2 + 2 * k] << 8 | header[3 + 2 * k]);
    return box;
}

/// The left side bearing of a glyph as the font states it. FreeType tells that of the outline's control
/// points instead, which may begin farther left than the outline.
std::optional<double> statedBearing(FT_Face face, FT_UInt glyph) {
    const auto* header = static_cast<const TT_HoriHeader*>(FT_Get_Sfnt_Table(face, FT_SFNT_HHEA));
    if (!header) return {};
    const FT_ULong full = header->number_Of_HMetrics;
    const FT_ULong place = glyph < full ? 4 * FT_ULong{glyph} + 2 : 4 * full + 2 * (glyph - full);
    const std::vector<FT_Byte> bytes = tableBytes(face, TTAG_hmtx, place, 2);
    if (bytes.empty()) return {};
    return static_cast<std::int16_t>(bytes[0] << 8 | bytes[1]);
}

}  // namespace

FontFile::FontFile(std::unique_ptr<Face> face) : face_(std::move(face)) {}
FontFile::~FontFile() = default;

std::unique_ptr<FontFile> FontFile::open(const std::filesystem::path& file) {
    auto face = std::make_unique<Face>();
    if (FT_Init_FreeType(&face->library) != 0) return nullptr;
    if (FT_New_Face(face->library, file.c_str(), 0, &face->face) != 0) return nullptr;
    if (!FT_IS_SCALABLE(face->face) || face->face->units_per_EM == 0) return nullptr;
    return std::unique_ptr<FontFile>(new FontFile(std::move(face)));
}

FontFile::Glyph FontFile::glyph(char32_t character) const {
    Glyph result;
    FT_Face face = face_->face;
    const FT_UInt index = FT_Get_Char_Index(face, character);
    if (FT_Load_Glyph(face, index, FT_LOAD_NO_SCALE) != 0) return result;
    Pen pen;
    pen.scale = 1.0 / face->units_per_EM;
    result.advance = static_cast<double>(face->glyph->advance.x) * pen.scale;
    const auto drawn = static_cast<double>(face->glyph->metrics.horiBearingX);
    result.bearing = statedBearing(face, index).value_or(drawn) * pen.scale;
    // POV-Ray moves the outline, control points included, to where the font states its beginning.
    pen.shift = result.bearing - drawn * pen.scale;
    if (face->glyph->format != FT_GLYPH_FORMAT_OUTLINE) return result;
    if (const auto box = statedBox(face, index)) {
        // FreeType moves the outline so that the box begins at the bearing.
        const std::array<double, 4>& c = *box;
        result.low = {result.bearing, c[1] * pen.scale};
        result.high = {result.bearing + (c[2] - c[0]) * pen.scale, c[3] * pen.scale};
    } else {
        result.low = result.high = {result.bearing, 0};
    }
    // FreeType takes the points between two off the curve as whole numbers: finer units keep their halves.
    constexpr FT_Fixed finer = 64;
    const FT_Matrix enlarge{finer << 16, 0, 0, finer << 16};
    FT_Outline_Transform(&face->glyph->outline, &enlarge);
    pen.scale /= finer;
    const FT_Outline_Funcs functions{moveTo, lineTo, conicTo, cubicTo, 0, 0};
    if (FT_Outline_Decompose(&face->glyph->outline, &functions, &pen) != 0) return result;
    pen.close();
    result.outline = std::move(pen.pieces);
    return result;
}

double FontFile::kerning(char32_t left, char32_t right) const {
    FT_Face face = face_->face;
    if (!FT_HAS_KERNING(face)) return 0;
    FT_Vector kern{};
    const FT_UInt first = FT_Get_Char_Index(face, left), second = FT_Get_Char_Index(face, right);
    if (FT_Get_Kerning(face, first, second, FT_KERNING_UNSCALED, &kern) != 0) return 0;
    return static_cast<double>(kern.x) / face->units_per_EM;
}

}  // namespace isoscope
