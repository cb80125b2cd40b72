// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/language/value.h"

namespace isoscope {

/// Names and what they stand for: one global scope, and one more for each include file and macro call that is
/// running (`#local` names live there).
class SymbolTable {
  public:
    SymbolTable();

    /// The innermost value of a name, or null.
    const Value* find(std::string_view name) const;
    Value* find(std::string_view name);

    /// `#declare`: replaces the innermost value of the name where it has one, else makes a global one.
    void declare(const std::string& name, Value value);
    /// `#local`: in the innermost scope.
    void declareLocal(const std::string& name, Value value);
    /// `#undef`; false when there was none.
    bool undefine(std::string_view name);

    void pushScope();
    void popScope();
    std::size_t scopeCount() const { return scopes_.size(); }

    /// Every visible name, sorted: for completion and "did you mean".
    std::vector<std::string> names() const;

  private:
    std::vector<std::map<std::string, Value, std::less<>>> scopes_;
};

/// The candidate closest to `name` by edit distance, or "" when none is close enough to be a likely typing error.
std::string closestName(std::string_view name, const std::vector<std::string>& candidates);

}  // namespace isoscope
