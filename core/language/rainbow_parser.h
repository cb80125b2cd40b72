// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/language/scene_draft.h"

namespace isoscope {

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

}  // namespace isoscope
