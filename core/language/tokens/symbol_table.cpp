// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/tokens/symbol_table.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
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

void SymbolTable::forEach(const std::function<void(const std::string&, const Value&)>& visit) const {
    for (const Scope& scope : scopes_)
        for (const auto& [name, entry] : scope) {
            const Value& value = const_cast<Entry&>(entry).resolved();
            if (!std::holds_alternative<std::monostate>(value.data)) visit(name, value);
        }
}

namespace {

constexpr std::size_t longestName = 64;

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; }

/// Damerau-Levenshtein distance with neighbouring swaps, in half edits: upper for lower case is one, all that
/// a name has of them together not more than one edit. Anything above `limit` may come out as any number
/// above it.
int halfEditsBetween(std::string_view a, std::string_view b, int limit) {
    using Row = std::array<int, longestName + 4>;
    std::array<Row, 3> rows;
    const auto row = [&rows](std::size_t i) -> Row& { return rows[i % 3]; };
    for (std::size_t j = 0; j <= b.size(); ++j) row(0)[j] = static_cast<int>(2 * j);
    bool sameCase = true;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        Row& now = row(i);
        const Row& before = row(i - 1);
        now[0] = static_cast<int>(2 * i);
        int least = now[0];
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const bool same = lower(a[i - 1]) == lower(b[j - 1]);
            now[j] = std::min({before[j] + 2, now[j - 1] + 2, before[j - 1] + (same ? 0 : 2)});
            if (i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]))
                now[j] = std::min(now[j], row(i - 2)[j - 2] + 2);
            least = std::min(least, now[j]);
        }
        if (least > limit) return least;
        sameCase = sameCase && (i > b.size() || lower(a[i - 1]) != lower(b[i - 1]) || a[i - 1] == b[i - 1]);
    }
    return row(a.size())[b.size()] + (sameCase ? 0 : 1);
}

/// A bit for each letter that occurs, whatever its case; some letters share one.
std::uint64_t lettersOf(std::string_view name) {
    std::uint64_t letters = 0;
    for (const char c : name) letters |= std::uint64_t{1} << (static_cast<unsigned char>(lower(c)) % 64);
    return letters;
}

}  // namespace

std::string closestName(std::string_view name, const std::vector<std::string>& candidates, int* distance) {
    if (name.empty() || name.size() > longestName) return {};
    // One typing error in a short name, two or three in a long one; a one-letter name is never "close".
    int best = name.size() < 2 ? 1 : name.size() < 5 ? 3 : name.size() < 8 ? 5 : 7;
    std::string closest;
    const std::uint64_t letters = lettersOf(name);
    for (const std::string& candidate : candidates) {
        // An edit changes the length by one at most, and takes or brings one letter at most.
        const auto tooFar = [&](std::size_t edits) { return 2 * edits > static_cast<std::size_t>(best); };
        const std::size_t longer = std::max(candidate.size(), name.size());
        const std::size_t shorter = std::min(candidate.size(), name.size());
        if (tooFar(longer - shorter) || candidate == name) continue;
        const std::uint64_t others = lettersOf(candidate);
        if (tooFar(static_cast<std::size_t>(std::popcount(letters & ~others))) ||
            tooFar(static_cast<std::size_t>(std::popcount(others & ~letters))))
            continue;
        const int found = halfEditsBetween(name, candidate, best);
        // Of two equally far the one that begins as it was typed: a name not typed to its end.
        const bool isBetterTie =
            found == best &&
            (closest.empty() || (candidate.starts_with(name) && !closest.starts_with(name)) ||
             (candidate[0] == name[0] && closest[0] != name[0]));
        if (found < best || isBetterTie) {
            best = found;
            closest = candidate;
        }
    }
    if (distance) *distance = best;
    return closest;
}

}  // namespace isoscope
