// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/symbol_table.h"

#include <algorithm>
#include <set>

namespace isoscope {

SymbolTable::SymbolTable() : scopes_(1) {}

SymbolTable::Entry* SymbolTable::findEntry(std::string_view name, std::size_t scopeCount) {
    for (std::size_t i = scopeCount; i-- > 0;) {
        if (scopes_[i].empty()) continue;
        const auto found = scopes_[i].find(name);
        if (found != scopes_[i].end()) return &found->second;
    }
    return nullptr;
}

const Value* SymbolTable::find(std::string_view name) const {
    return const_cast<SymbolTable*>(this)->find(name);
}

Value* SymbolTable::find(std::string_view name) {
    Entry* entry = findEntry(name, scopes_.size());
    if (!entry) return nullptr;
    Value& value = entry->resolved();
    return std::holds_alternative<std::monostate>(value.data) ? nullptr : &value;
}

void SymbolTable::declare(const std::string& name, Value value) {
    declare(name, std::move(value), scopes_.size());
}

void SymbolTable::declareLocal(const std::string& name, Value value) {
    declareLocal(name, std::move(value), scopes_.size());
}

void SymbolTable::declare(const std::string& name, Value value, std::size_t scopeCount) {
    Entry* entry = findEntry(name, std::min(scopeCount, scopes_.size()));
    (entry ? entry->resolved() : scopes_.front()[name].value) = std::move(value);
}

void SymbolTable::declareLocal(const std::string& name, Value value, std::size_t scopeCount) {
    scopes_[std::min(scopeCount, scopes_.size()) - 1][name].resolved() = std::move(value);
}

bool SymbolTable::undefine(std::string_view name) {
    for (std::size_t i = scopes_.size(); i-- > 0;) {
        const auto found = scopes_[i].find(name);
        if (found == scopes_[i].end()) continue;
        // Running macros may still refer to the value; it stays as "nothing".
        if (i + 1 < scopes_.size() || found->second.target || found->second.array)
            found->second.resolved() = Value{};
        else
            scopes_[i].erase(found);
        return true;
    }
    return false;
}

bool SymbolTable::declareReference(const std::string& name, std::string_view target) {
    Entry* entry = findEntry(target, scopes_.size() - 1);
    if (!entry) return false;
    Entry reference;
    if (entry->array) {
        reference.array = entry->array;
        reference.element = entry->element;
    } else {
        reference.target = &entry->resolved();
    }
    scopes_.back()[name] = std::move(reference);
    return true;
}

void SymbolTable::declareReference(const std::string& name, std::shared_ptr<ArrayValue> array,
                                   std::size_t element) {
    Entry reference;
    reference.array = std::move(array);
    reference.element = element;
    scopes_.back()[name] = std::move(reference);
}

void SymbolTable::pushScope() { scopes_.emplace_back(); }

void SymbolTable::popScope() {
    if (scopes_.size() > 1) scopes_.pop_back();
}

std::vector<std::string> SymbolTable::names() const {
    std::set<std::string> all;
    for (const Scope& scope : scopes_)
        for (const auto& [name, entry] : scope)
            if (find(name)) all.insert(name);
    return {all.begin(), all.end()};
}

namespace {

/// Levenshtein distance with neighbouring swaps, upper and lower case half a step apart; in half steps.
int halfStepsBetween(std::string_view a, std::string_view b) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
    const auto cost = [&](char p, char q) { return p == q ? 0 : lower(p) == lower(q) ? 1 : 2; };
    std::vector<std::vector<int>> d(a.size() + 1, std::vector<int>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = static_cast<int>(2 * i);
    for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = static_cast<int>(2 * j);
    for (std::size_t i = 1; i <= a.size(); ++i)
        for (std::size_t j = 1; j <= b.size(); ++j) {
            d[i][j] =
                std::min({d[i - 1][j] + 2, d[i][j - 1] + 2, d[i - 1][j - 1] + cost(a[i - 1], b[j - 1])});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 2);
        }
    return d[a.size()][b.size()];
}

}  // namespace

std::string closestName(std::string_view name, const std::vector<std::string>& candidates) {
    constexpr std::size_t longestName = 64;
    if (name.empty() || name.size() > longestName) return {};
    // One typing error in a short name, two or three in a long one; a one-letter name is never "close".
    int best = name.size() < 2 ? 1 : name.size() < 4 ? 2 : name.size() < 8 ? 4 : 6;
    std::string closest;
    for (const std::string& candidate : candidates) {
        const std::size_t longer = std::max(candidate.size(), name.size());
        const std::size_t shorter = std::min(candidate.size(), name.size());
        if (longer - shorter > 3 || candidate == name) continue;
        const int distance = halfStepsBetween(name, candidate);
        // Of two equally far the one that begins as it was typed: a name not typed to its end.
        const bool isBetterTie =
            distance == best &&
            (closest.empty() || (candidate.starts_with(name) && !closest.starts_with(name)));
        if (distance < best || isBetterTie) {
            best = distance;
            closest = candidate;
        }
    }
    return closest;
}

}  // namespace isoscope
