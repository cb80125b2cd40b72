// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/language/token_stream.h"
#include "core/texture/image_map.h"

namespace isoscope {

/// The block of `image_map { ... }` behind its word. A file that is named again is not read again.
class ImageMapParser {
  public:
    explicit ImageMapParser(TokenStream& tokens) : tokens_(tokens) {}

    /// Null when the image cannot be shown, which has been reported; the block is left behind.
    std::shared_ptr<const ImageMap> parse();
    /// Settings that have no effect here, by the words of the language.
    const std::vector<std::string>& leftOut() const { return leftOut_; }

  private:
    bool parseFile(ImageMap& image);
    bool parseSetting(ImageMap& image);
    void parseTransparency(std::size_t channel, ImageMap& image);

    TokenStream& tokens_;
    std::vector<std::string> leftOut_;
};

}  // namespace isoscope
