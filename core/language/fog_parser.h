// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/language/scene_draft.h"

namespace isoscope {

/// `fog { ... }`.
class FogParser {
  public:
    explicit FogParser(TokenStream& tokens) : tokens_(tokens) {}

    /// The block with its braces; the word `fog` has been read.
    Fog parse();

  private:
    bool parseItem();
    bool parseNumberItem();

    TokenStream& tokens_;
    Fog fog_;
};

}  // namespace isoscope
