// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/language/scene_draft.h"
#include "core/language/textures/normal_parser.h"
#include "core/language/textures/pattern_reader.h"

namespace isoscope {

/// `texture`, `material` and what stands in them.
class TextureParser {
  public:
    TextureParser(TokenStream& tokens, const Material& defaults)
        : tokens_(tokens), reader_(tokens), defaults_(defaults) {}

    /// The block with its braces; the word `texture` has been read.
    Material parseTexture();
    /// The same with the textures that follow it, each a layer over those before.
    Material parseTextures();
    /// The same behind `interior_texture`.
    Material parseInteriorTextures();
    /// The block with its braces; the word `material` has been read.
    Material parseMaterial();
    /// The block of `texture_map`, to be declared: a texture without a pattern.
    Material parseMap();
    /// Reads `pigment`, `finish` or `normal` with its block, if one comes next, into the material.
    bool parsePart(Material& material);
    /// The material, or the default with a message when it is made of too many textures.
    Material limited(Material material);

  private:
    void parseBody(Material& material, std::string_view end, std::string_view keyword);
    bool parseTextureItem(Material& material);
    bool parseMapItem(Material& material);
    /// `texture { ... }`, the next entry of a list; false, and nothing is read, where there is none.
    bool addListEntry();
    void addEntry();
    void parseTiles();
    void parseMaterialMap();
    void closeTextures(std::string_view keyword);
    void applyFlags(Material& material);
    void parseTextureMap();
    void completeList();
    void finishMap(Material& material);
    bool startFromDeclared(Material& material);
    TokenStream& tokens_;
    PatternReader reader_;
    const Material& defaults_;
    std::optional<MappedTexture> mapped_;  ///< the pattern of textures that is being read
    bool onSurface_ = false;               ///< `uv_mapping`
    bool unscaledBumps_ = false;           ///< `no_bump_scale`
};

/// Adds the keyword to the list unless it is there.
void addNotSimulated(std::vector<std::string>& list, std::string_view keyword);

/// What a material asks for that has no effect here, as sentences.
std::vector<std::string> leftOutSentences(const Material& material);

}  // namespace isoscope
