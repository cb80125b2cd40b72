// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>

#include "core/language/scene_draft.h"

namespace isoscope {

/// `interior { ... }`.
class InteriorParser {
  public:
    /// Lists of the words that may begin an item of the block, for "did you mean".
    static const std::array<const char*, 3> itemWords;

    explicit InteriorParser(TokenStream& tokens) : tokens_(tokens) {}

    /// The block with its braces; the word `interior` has been read. Never null.
    std::shared_ptr<const Interior> parse();

  private:
    bool parseItem();
    bool parseNumberItem();

    TokenStream& tokens_;
    Interior interior_;
};

}  // namespace isoscope
