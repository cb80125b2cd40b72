// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/language/functions/function_scope.h"
#include "core/language/tokens/token_stream.h"

namespace isoscope {

/// The blocks of `function { pattern { ... } }` and `function { pigment { ... } }` as functions of x, y, z.
class PatternParser {
  public:
    PatternParser(TokenStream& tokens, FunctionScope& scope) : tokens_(tokens), scope_(scope) {}

    /// From the `{` to the `}`; the word `pattern` has been read. The node of the value, or nothing after a
    /// mistake and for patterns that are left out; the block is left behind in both cases.
    std::optional<NodeId> parse();
    /// The same for a pigment: red, green, blue, filter and transmit, or nothing.
    std::vector<NodeId> parsePigment();

  private:
    bool parseItems(class PatternReader& reader);
    bool leaveOut(const Token& word);

    TokenStream& tokens_;
    FunctionScope& scope_;
};

}  // namespace isoscope
