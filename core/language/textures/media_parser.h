// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/language/scene_draft.h"
#include "core/scene/medium.h"

namespace isoscope {

/// `media { ... }`.
class MediaParser {
  public:
    explicit MediaParser(TokenStream& tokens) : tokens_(tokens) {}

    /// The block with its braces; the word `media` has been read. Never null.
    std::shared_ptr<const Medium> parse();
    /// The same, added to those that fill a space, or with a message where there are too many.
    void parseInto(std::vector<std::shared_ptr<const Medium>>& media);

  private:
    bool parseItem();
    void parseScattering();
    void parseDensity();
    bool parseSampling();
    bool parseIgnored();
    void limitSamples(const SourceRange& place);
    int parseCount(const char* name, int limit);

    TokenStream& tokens_;
    Medium medium_;
    std::vector<Material> densities_;
    bool begun_ = false;  ///< something has been read
};

}  // namespace isoscope
