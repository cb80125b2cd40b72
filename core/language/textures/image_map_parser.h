// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/language/tokens/token_stream.h"
#include "core/texture/image_map.h"

namespace isoscope {

/// The image of `image_map`, `image_pattern`, `bump_map` and `material_map`, with what may follow its file. A
/// file that is named again is not read again.
class ImageMapParser {
  public:
    explicit ImageMapParser(TokenStream& tokens) : tokens_(tokens) {}

    /// The block of `image_map { ... }` behind its word. Null when the image cannot be shown, which has been
    /// reported; the block is left behind.
    std::shared_ptr<const ImageMap> parse();

    // For blocks that hold more than the image: its name, its settings one by one while there are any, and
    // then the image itself.

    /// The kind and name of the image file, which must exist. False otherwise, which has been reported.
    bool parseFile();
    /// One setting (`once`, `map_type 2`, ...). False, with nothing taken, at any other token.
    bool parseSetting();
    /// Reads the file with the settings so far. Null when it cannot be read, which has been reported.
    std::shared_ptr<const ImageMap> read();

    /// Settings that have no effect here, by the words of the language.
    const std::vector<std::string>& leftOut() const { return leftOut_; }
    /// Whether the text asked for the transparency of the file, for the numbers of its palette, or for its
    /// colours; nothing where it did not say.
    std::optional<bool> usesAlpha() const { return usesAlpha_; }
    std::optional<bool> usesIndex() const { return usesIndex_; }

  private:
    struct Transparency {
        std::size_t channel = 3;
        std::optional<int> index;  ///< of the palette; else all
        float amount = 0;
    };

    bool parseKind();
    void parseGamma();
    void parseTransparency(std::size_t channel);
    void makeTransparent(ImageMap& image) const;

    TokenStream& tokens_;
    ImageMap settings_;
    std::filesystem::path file_;
    std::string ending_ = "png";  ///< of files of the kind that is named
    std::string name_;
    SourceRange range_;
    std::optional<double> gamma_;
    std::vector<Transparency> transparencies_;
    std::optional<bool> usesAlpha_, usesIndex_, premultiplied_;
    std::vector<std::string> leftOut_;
};

}  // namespace isoscope
