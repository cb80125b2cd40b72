// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/language/token_stream.h"

namespace isoscope {

/// Counts statements inside statements while it lives. Beyond `limit` it reports the place once, and ok() is false: no
/// text may use up the parser's own stack.
class NestingGuard {
  public:
    static constexpr int limit = 100;

    explicit NestingGuard(TokenStream& tokens) : context_(tokens.context()) {
        if (++context_.nesting == limit + 1)
            context_.error("too-deep", tokens.lastRange(),
                           "Statements are nested more than " + std::to_string(limit) + " deep here.");
    }
    ~NestingGuard() { --context_.nesting; }
    NestingGuard(const NestingGuard&) = delete;
    NestingGuard& operator=(const NestingGuard&) = delete;

    bool ok() const { return context_.nesting <= limit; }

  private:
    ParseContext& context_;
};

}  // namespace isoscope
