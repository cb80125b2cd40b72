// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/language/scene_draft.h"

namespace isoscope {

/// `sky_sphere { ... }`: pigments, transformations, `emission`.
class SkyParser {
  public:
    SkyParser(TokenStream& tokens, const SceneDraft& draft) : tokens_(tokens), draft_(draft) {}

    /// The block with its braces; the word `sky_sphere` has been read. Never null.
    std::shared_ptr<const SkySphere> parse();

  private:
    bool parseItem(SkySphere& sky);

    TokenStream& tokens_;
    const SceneDraft& draft_;
};

}  // namespace isoscope
