// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "core/language/scene_draft.h"
#include "core/language/textures/normal_parser.h"

namespace isoscope {

/// The statements of a scene, one after another. A statement with a mistake is left behind and the next one
/// is read; what the program does not simulate is skipped and reported.
class SceneParser {
  public:
    SceneParser(TokenStream& tokens, SceneDraft& draft);

    /// Reads to the end of the text.
    void parse();

  private:
    void parseStatement();
    bool parseKnown(const Token& word);
    void parseCamera(const Token& word);
    void parseBackground();
    /// The bare name of a declared object or light; false, and nothing is read, where there is none.
    bool parseName();
    /// `declare` or `include`, taken, without the `#` that was not wanted before POV-Ray 3.
    void runBareDirective(const Token& word);
    void parseLight();
    Value parseLightValue();
    void parseObject();
    void addObject(const ObjectPointer& object);
    void parseUnknown(const Token& token);
    /// A formula where a statement should stand is one mistake, whatever it is made of.
    bool passFormula(const Token& first);

    /// What follows `#declare NAME =`; see TokenStream::ValueParser.
    std::optional<Value> parseValue();
    NormalPointer defaultNormal() const;
    std::optional<Value> parseAppearance(const Token& word);
    std::optional<Value> parseObjectValue(const Token& word);
    /// The block of `#default`, braces included.
    void parseDefault();

    TokenStream& tokens_;
    SceneDraft& draft_;
    /// A mistake has been told, and no statement has been understood since: what may be left of that one is
    /// passed over, all but names with a block, which are statements of their own.
    bool mistaken_ = false;
};

}  // namespace isoscope
