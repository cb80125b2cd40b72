// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/function/graph_builder.h"
#include "core/language/token_stream.h"

namespace isoscope {

/// The entries of a colour map in the order of their positions.
struct ColorRamp {
    struct Entry {
        double position = 0;
        Color color;
    };
    std::vector<Entry> entries;
};

/// `color_map { [position color] ... }`.
class ColorRampParser {
  public:
    explicit ColorRampParser(TokenStream& tokens) : tokens_(tokens) {}

    /// The block with its braces; the word has been read. False after a mistake (reported, the block left
    /// behind).
    bool parse(ColorRamp& ramp);

  private:
    TokenStream& tokens_;
};

/// What `pick` takes of the ramp's colour at `value`: straight between neighbouring entries, the outermost
/// colours beyond them; 0 without entries.
Expression rampValue(const ColorRamp& ramp, Expression value, double (*pick)(const Color&));
/// Its brightness: 0.297 red + 0.589 green + 0.114 blue.
Expression grayOf(const ColorRamp& ramp, Expression value);

}  // namespace isoscope
