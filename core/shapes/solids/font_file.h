// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "core/shapes/solids/plane_curve.h"

namespace isoscope {

/// The glyphs of a TrueType font (of a collection, its first), measured in units of the line height. Not to
/// be used by two threads at once.
class FontFile {
  public:
    /// Null when the file is no font with outlines.
    static std::unique_ptr<FontFile> open(const std::filesystem::path& file);
    ~FontFile();
    FontFile(const FontFile&) = delete;
    FontFile& operator=(const FontFile&) = delete;

    /// One character's shape, its pen at the origin, x to the right and y up, in units of the line height.
    struct Glyph {
        std::vector<CurvePiece> outline;  ///< empty for blanks
        double advance = 0;               ///< to where the next one begins
        double bearing = 0;               ///< from the beginning to the outline
        glm::dvec2 low{0}, high{0};       ///< the box that the font states for the outline
    };
    /// What the font draws for characters that it does not have, for those.
    Glyph glyph(char32_t character) const;
    /// What the font wants to be added to the advance between two characters.
    double kerning(char32_t left, char32_t right) const;

  private:
    struct Face;
    explicit FontFile(std::unique_ptr<Face> face);

    std::unique_ptr<Face> face_;
};

}  // namespace isoscope
