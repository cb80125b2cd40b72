// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <unordered_map>
#include <vector>

#include "core/language/expressions/value.h"

namespace isoscope {

/// Names and what they stand for: one global scope, and one more for each include file and macro call that is
/// running (`#local` names live there). As in POV-Ray, a name is looked for in all running scopes, innermost
/// first. Pointers to values stay valid until the value's name is declared anew or its scope ends.
class SymbolTable {
  public:
    SymbolTable();

    /// The innermost value of a name; null when it has none.
    const Value* find(std::string_view name) const;
    Value* find(std::string_view name);

    /// `#declare`: replaces the innermost value of the name where it has one, else makes a global one.
    void declare(const std::string& name, Value value);
    /// `#local`: in the innermost scope.
    void declareLocal(const std::string& name, Value value);
    /// The same as if only the outermost `scopeCount` scopes were there: a directive belongs to the scopes in
    /// which it begins, even if the macro that supplies its value is still running when the value is
    /// complete.
    void declare(const std::string& name, Value value, std::size_t scopeCount);
    void declareLocal(const std::string& name, Value value, std::size_t scopeCount);
    /// `#undef`; false when there was none.
    bool undefine(std::string_view name);

    /// Makes `name` in the innermost scope another name of what `target` stands for in the scopes around it:
    /// a macro's parameter. False, and nothing happens, when `target` is unknown there.
    bool declareReference(const std::string& name, std::string_view target);
    /// The same for one element of an array; `element` must be within it.
    void declareReference(const std::string& name, std::shared_ptr<ArrayValue> array, std::size_t element);

    /// Open and close the scope of an include file or macro call; the global one is never closed.
    void pushScope();
    void popScope();
    /// At least 1, the global one.
    std::size_t scopeCount() const { return scopes_.size(); }

    /// Every visible name, sorted: for completion and "did you mean".
    std::vector<std::string> names() const;
    /// Calls `visit(name, value)` for every name of every scope that has a value, in no order; one that
    /// another scope hides may come, too. Unlike names() it keeps nothing, however many there are.
    void forEach(const std::function<void(const std::string&, const Value&)>& visit) const;

  private:
    struct Entry {
        Value value;
        Value* target = nullptr;            ///< of a reference to a name; map nodes do not move
        std::shared_ptr<ArrayValue> array;  ///< of a reference to an element
        std::size_t element = 0;

        Value& resolved() { return target ? *target : array ? array->elements[element] : value; }
    };
    struct Hash {
        using is_transparent = void;
        std::size_t operator()(std::string_view name) const noexcept {
            return std::hash<std::string_view>()(name);
        }
    };
    using Scope = std::unordered_map<std::string, Entry, Hash, std::equal_to<>>;
    static_assert(std::is_nothrow_move_constructible_v<Scope>, "nodes must stay when scopes_ grows");
    Entry* findEntry(std::string_view name, std::size_t scopeCount);

    std::vector<Scope> scopes_;
};

/// The candidate closest to `name` by edit distance (wrong, missing, additional and swapped letters; upper
/// and lower case differ little), or "" when none is close enough, for the length of `name`, to be a likely
/// typing error. `distance` becomes its distance, in half edits.
std::string closestName(std::string_view name, const std::vector<std::string>& candidates,
                        int* distance = nullptr);

}  // namespace isoscope
