// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/language/scene_draft.h"

namespace isoscope {

/// `global_settings { ... }`. Settings that only concern effects this program does not have are passed over
/// silently; those that would change the picture are reported.
class GlobalSettingsParser {
  public:
    GlobalSettingsParser(TokenStream& tokens, SceneDraft& draft) : tokens_(tokens), draft_(draft) {}

    /// The block with its braces; the word `global_settings` has been read.
    void parse();

  private:
    bool parseItem();
    void parseGamma();
    void parseNoiseGenerator();
    bool parseWithoutEffect();

    TokenStream& tokens_;
    SceneDraft& draft_;
};

}  // namespace isoscope
