// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace isoscope {

/// The integer generator behind the noise tables and the wave sources (docs/povray/noise.md, section 1).
class LinearCongruential {
  public:
    constexpr explicit LinearCongruential(std::uint32_t seed) : state_(seed) {}

    /// The next draw, 0 to 32767.
    constexpr std::uint32_t next() {
        state_ = 1812433253u * state_ + 12345u;
        return (state_ >> 16) & 0x7fffu;
    }

  private:
    std::uint32_t state_;
};

}  // namespace isoscope
