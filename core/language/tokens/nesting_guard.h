// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/language/tokens/token_stream.h"

namespace isoscope {

/// Counts statements, parentheses and directives inside one another while it lives. Beyond `limit` reading is
/// cut off with a message, and ok() is false: no text may use up the parser's own stack. To be made wherever
/// a parser may call itself.
class NestingGuard {
  public:
    static constexpr int limit = 256;

    explicit NestingGuard(TokenStream& tokens) : context_(tokens.context()) {
        if (++context_.nesting > limit)
            tokens.cut("too-deep", tokens.lastRange(),
                       "Reading stops here: statements, parentheses or directives are nested more than " +
                           std::to_string(limit) + " deep.");
    }
    ~NestingGuard() { --context_.nesting; }
    NestingGuard(const NestingGuard&) = delete;
    NestingGuard& operator=(const NestingGuard&) = delete;

    /// False beyond the limit: the parser returns without going deeper.
    bool ok() const { return context_.nesting <= limit; }

  private:
    ParseContext& context_;
};

}  // namespace isoscope
