// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/language/scene_draft.h"

namespace isoscope {

/// `texture`, `material` and what stands in them. Textures that differ from place to place are drawn as their
/// first part.
class TextureParser {
  public:
    TextureParser(TokenStream& tokens, const Material& defaults) : tokens_(tokens), defaults_(defaults) {}

    /// The block with its braces; the word `texture` has been read.
    Material parseTexture();
    /// The block with its braces; the word `material` has been read.
    Material parseMaterial();
    /// Reads `pigment`, `finish` or `normal` with its block, if one comes next, into the material.
    bool parsePart(Material& material);

  private:
    void parseBody(Material& material, std::string_view end, std::string_view keyword);
    bool parseTextureItem(Material& material);
    bool parseTextureMap(Material& material);
    bool startFromDeclared(Material& material);
    void skipPatternItem();

    TokenStream& tokens_;
    const Material& defaults_;
    bool pattern_ = false;
};

/// Adds the keyword to the list unless it is there.
void addNotSimulated(std::vector<std::string>& list, std::string_view keyword);

/// What a material asks for that has no effect here, as sentences.
std::vector<std::string> leftOutSentences(const Material& material);

}  // namespace isoscope
