// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/function/pattern.h"
#include "core/language/function_scope.h"
#include "core/language/token_stream.h"
#include "core/shapes/transform.h"

namespace isoscope {

/// The block of `pattern { NAME modifiers }` as a function of x, y, z (spec/patterns.md).
class PatternParser {
  public:
    PatternParser(TokenStream& tokens, FunctionScope& scope) : tokens_(tokens), scope_(scope) {}

    /// From the `{` to the `}`; the word `pattern` has been read. The node of the value, or nothing after a mistake and
    /// for patterns that are left out; the block is left behind in both cases.
    std::optional<NodeId> parse();

  private:
    bool parseName();
    bool parseNameArguments(const Token& name);
    bool parseModifier();
    bool parseWave(const Token& word);
    bool parseCrackleModifier(const Token& word);
    NodeId build();
    bool leaveOut(const Token& word);

    TokenStream& tokens_;
    FunctionScope& scope_;
    Pattern pattern_;
    Transform transform_;
};

}  // namespace isoscope
