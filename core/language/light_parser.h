// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/language/objects/object_description.h"
#include "core/language/scene_draft.h"

namespace isoscope {

/// `light_source { ... }`; items without effect are reported.
class LightParser {
  public:
    /// Lists of the words that may begin an item of the block, for "did you mean".
    static const std::array<const char*, 3> itemWords;

    /// Without `draft` there is no place for the objects of `looks_like` and `projected_through`: they are
    /// left out and reported.
    explicit LightParser(TokenStream& tokens, SceneDraft* draft = nullptr) : tokens_(tokens), draft_(draft) {}

    /// The block with its braces; the word `light_source` has been read.
    LightSource parse();
    /// The object of `looks_like`, moved to the light; null without one.
    const ObjectPointer& looks() const { return looks_; }

  private:
    void parseStart(LightSource& light);
    bool parseItem(LightSource& light);
    bool parseKind(LightSource& light);
    bool parseNumberItem(LightSource& light);
    void warnWithoutBeam(const SourceRange& start, const char* kinds);
    bool parseArea(LightSource& light);
    bool parseAreaItem(LightSource& light);
    bool parseLooks(const LightSource& light);
    void moveLooks(const Transform& transform);
    bool parseMediaItem(LightSource& light);
    bool parseBlockItem(LightSource& light);

    TokenStream& tokens_;
    SceneDraft* draft_;
    ObjectPointer looks_;
    LightArea areaSaid_;    ///< what is said of the area before `area_light`
    bool hasBeam_ = false;  ///< `spotlight` or `cylinder` has been read, and no `shadowless` since
};

/// The light carried by a transform.
LightSource transformed(const LightSource& light, const Transform& transform);

}  // namespace isoscope
