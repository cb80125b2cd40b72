// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/language/scene_draft.h"

namespace isoscope {

/// `light_source { ... }`. looks_like, projected_through and photons are left out.
class LightParser {
  public:
    explicit LightParser(TokenStream& tokens) : tokens_(tokens) {}

    /// The block with its braces; the word `light_source` has been read.
    LightSource parse();

  private:
    bool parseStart(LightSource& light);
    bool parseItem(LightSource& light);
    bool parseNumberItem(LightSource& light);
    bool parseArea(LightSource& light);
    bool parseAreaItem(LightSource& light);
    bool parseBlockItem();

    TokenStream& tokens_;
};

/// The light carried by a transform.
LightSource transformed(const LightSource& light, const Transform& transform);

}  // namespace isoscope
