// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "core/language/parse_context.h"

namespace isoscope {

/// While it lives, the sliders found belong to one statement or call, which gets a number of its own
/// (SceneParameter::statement). Inner statements have theirs; the outer one's comes back behind them.
class StatementScope {
  public:
    explicit StatementScope(ParseContext& context)
        : context_(context), outer_(std::exchange(context.statement, ++context.statementCount)) {}
    ~StatementScope() { context_.statement = outer_; }
    StatementScope(const StatementScope&) = delete;
    StatementScope& operator=(const StatementScope&) = delete;

  private:
    ParseContext& context_;
    int outer_;
};

}  // namespace isoscope
