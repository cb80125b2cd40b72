// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/language/scene_draft.h"

namespace isoscope {

/// `finish { ... }` with every keyword of POV-Ray 3.7; Finish::notSimulated names those without effect.
class FinishParser {
  public:
    /// Lists of the words that may begin an item of the block, for "did you mean".
    static const std::array<const char*, 3> itemWords;

    explicit FinishParser(TokenStream& tokens) : tokens_(tokens) {}

    /// The block with its braces, beginning from `start`; the word `finish` has been read.
    Finish parse(const Finish& start);

  private:
    bool parseItem();
    bool parseNumberItem();
    bool parseDiffuse();
    void parseReflection();
    void parseReflectionBlock();
    bool parseReflectionItem();
    bool parseIrid();
    bool parseLeftOut();
    void leaveOut(std::string_view word);
    /// A colour, or a float that stands for a grey.
    Color parseAmount();
    double parseOptionalNumber(double otherwise);

    TokenStream& tokens_;
    Finish finish_;
};

}  // namespace isoscope
