// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/function/patterns/pattern_warp.h"
#include "core/language/tokens/token_stream.h"
#include "core/texture/transform_warp.h"

namespace isoscope {

/// What moves the point at which a pattern is looked up: transformations and `warp { ... }`.
class WarpParser {
  public:
    explicit WarpParser(TokenStream& tokens) : tokens_(tokens) {}

    /// The block behind the word `warp`, braces included; nothing after a mistake (reported, the block left
    /// behind).
    std::optional<PatternWarp> parse();

  private:
    PatternWarp parseRepeat();
    PatternWarp parseTurbulence();
    PatternWarp parseBlackHole();
    PatternWarp parsePlanar();
    PatternWarp parseRound(RoundWarp::Kind kind);
    /// Of unit length.
    std::array<double, 3> parseOrientation();

    TokenStream& tokens_;
};

}  // namespace isoscope
