// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "core/language/expressions/parameter_collector.h"
#include "core/language/objects/object_description.h"
#include "core/language/scene_draft.h"

namespace isoscope {

/// The items of `isosurface { ... }` (docs/povray/isosurface.md); its numbers become sliders. Object
/// modifiers are read by ObjectParser.
class IsosurfaceParser {
  public:
    explicit IsosurfaceParser(TokenStream& tokens) : tokens_(tokens), parameters_(tokens.context()) {}

    /// Reads one item, if one comes next; false when something else does. `modifiers` is where the first
    /// modifier of the object begins, if one has been read: POV-Ray takes no items behind it.
    bool parseItem(const std::optional<SourceRange>& modifiers);
    /// Puts what was read into the description. Without a function that was understood it gets no shape, and
    /// the reason is reported: `start` is the keyword.
    void finish(ObjectDescription& description, const SourceRange& start);

    /// Something in the statement was not understood, perhaps its function: that it is missing is not blamed.
    void excuse() { excused_ = true; }

  private:
    bool parseOtherItem();
    bool parseNumberItem();
    void parseFunction();
    void parseContainer();
    void parseSphere();
    void parseBox();
    void parseEvaluate();
    void parseMaxTrace();
    void keepNames(int number);
    void offerSettings();
    glm::dvec3 parseCorner(const std::string& name);

    TokenStream& tokens_;
    ParameterCollector parameters_;
    IsosurfaceSettings settings_;
    SourceRange functionRange_, containerRange_;
    std::string functionText_;
    std::shared_ptr<const WrittenWork> written_;
    SourceRange lastItem_;
    std::array<bool, 3> given_{};  ///< which number items the text has
    bool hasFunction_ = false;
    bool hasItems_ = false;
    bool excused_ = false;
};

}  // namespace isoscope
