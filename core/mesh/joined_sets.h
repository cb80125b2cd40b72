// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace isoscope {

/// Disjoint sets of numbers below a limit (at most 2^32), each begun with one number and joined by and by.
/// The smallest number of a set stands for it, whatever the order of the joins.
class JoinedSets {
  public:
    explicit JoinedSets(std::size_t count) : parents_(count) {
        std::iota(parents_.begin(), parents_.end(), std::uint32_t(0));
    }

    /// The smallest number of the set.
    std::size_t find(std::size_t i) {
        while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
        return i;
    }
    /// Makes one set of two.
    void join(std::size_t a, std::size_t b) {
        a = find(a);
        b = find(b);
        if (a < b) parents_[b] = static_cast<std::uint32_t>(a);
        if (b < a) parents_[a] = static_cast<std::uint32_t>(b);
    }

  private:
    std::vector<std::uint32_t> parents_;
};

}  // namespace isoscope
