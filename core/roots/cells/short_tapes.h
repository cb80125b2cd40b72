// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "core/evaluate/prepared_function.h"

namespace isoscope {

/// Whether it is worth while to shorten the tape of a function piece by piece.
class ShortTapes {
  public:
    /// Tapes with fewer choices are not worth it.
    static constexpr std::size_t fewestChoices = 8;

    /// Tapes as short as this are not worth making shorter.
    static constexpr std::size_t shortLength = 24;

    explicit ShortTapes(const PreparedFunction& function)
        : length_(function.tape()->instructions().size()),
          possible_(function.links().whole().levelNumbers.size() >= fewestChoices &&
                    areShort(function.links().leastLength(), 1)) {}

    /// Whether the tape can become short at all.
    bool possible() const { return possible_; }
    /// Whether tapes that hold so many instructions together are short, in the place of `tapes` whole ones.
    bool areShort(std::size_t instructions, std::size_t tapes) const {
        constexpr std::size_t worthwhileShare = 2;
        return worthwhileShare * instructions < tapes * length_;
    }

  private:
    std::size_t length_;
    bool possible_;
};

}  // namespace isoscope
