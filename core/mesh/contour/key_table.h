// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace isoscope {

/// Values by keys of 64 bits, in the order in which they were added: open addressing, so that millions of
/// them take 24 bytes each beside the value. The key 2^64 - 1 is not for use.
template <class Value>
class KeyTable {
  public:
    static constexpr std::uint32_t none = ~std::uint32_t(0);

    /// The number of a key, or `none`.
    std::uint32_t find(std::uint64_t key) const {
        if (places_.empty()) return none;
        for (std::size_t at = hash(key);; at = (at + 1) & mask_) {
            const std::uint32_t number = places_[at];
            if (number == none || keys_[number] == key) return number;
        }
    }
    /// Adds a key with a value of its type's own making, unless it is there; returns its number.
    std::uint32_t add(std::uint64_t key) {
        if (2 * (keys_.size() + 1) > places_.size()) grow();
        std::size_t at = hash(key);
        for (; places_[at] != none; at = (at + 1) & mask_)
            if (keys_[places_[at]] == key) return places_[at];
        places_[at] = static_cast<std::uint32_t>(keys_.size());
        keys_.push_back(key);
        values_.emplace_back();
        return places_[at];
    }

    /// Keys and values by their numbers.
    std::size_t size() const { return keys_.size(); }
    std::uint64_t key(std::size_t number) const { return keys_[number]; }
    /// The bytes of so many keys, about: what is copied as the table grows is there twice.
    static constexpr std::size_t memoryFor(std::size_t keys) {
        return keys * (2 * (sizeof(std::uint64_t) + sizeof(Value)) + 3 * sizeof(std::uint32_t));
    }
    Value& operator[](std::size_t number) { return values_[number]; }
    const Value& operator[](std::size_t number) const { return values_[number]; }

  private:
    std::size_t hash(std::uint64_t key) const {
        return static_cast<std::size_t>((key * 0x9e3779b97f4a7c15u) >> 20) & mask_;
    }
    void grow() {
        const std::size_t size = places_.empty() ? 1024 : 2 * places_.size();
        places_.assign(size, none);
        mask_ = size - 1;
        for (std::size_t number = 0; number < keys_.size(); ++number) {
            std::size_t at = hash(keys_[number]);
            while (places_[at] != none) at = (at + 1) & mask_;
            places_[at] = static_cast<std::uint32_t>(number);
        }
    }

    std::vector<std::uint64_t> keys_;
    std::vector<Value> values_;
    std::vector<std::uint32_t> places_;
    std::size_t mask_ = 0;
};

}  // namespace isoscope
