// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/language/scene_draft.h"

namespace isoscope {

/// `pigment { ... }`. A pattern, a map or a picture is read through and stands as one colour: the mean of the
/// colours that it names, grey where it names none; SolidPigment::standsFor then says what it was.
class PigmentParser {
  public:
    explicit PigmentParser(TokenStream& tokens) : tokens_(tokens) {}

    /// The block with its braces, beginning from `start`; the word `pigment` has been read.
    Pigment parse(const Pigment& start);
    /// The block of `color_map`, `pigment_map` and the like with its braces, as the mean of its entries.
    Pigment parseMap();

    /// Whether the word begins a map of pigments or colours.
    static bool isMap(std::string_view word);

  private:
    struct Mean {
        Color sum;
        int count = 0;
        void add(const Color& color);
        Color value() const;
    };

    void parseBody(std::string_view end);
    bool parseColorItem();
    bool parsePatternItem();
    bool parseMapEntry(Mean& mean);
    bool startFromDeclared();
    bool atColor();
    Pigment result() const;

    TokenStream& tokens_;
    std::optional<Color> color_;
    Mean mean_;
    std::string standsFor_;
};

}  // namespace isoscope
