// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace isoscope {

/// The random numbers of `seed` and `rand`, the same as POV-Ray's, found by asking it: a stream holds a
/// 32-bit number s that becomes 1812433253 s + 12345 (modulo 2^32) at each call, and gives s / (2^32 - 1).
class RandomStreams {
  public:
    /// Begins a stream and returns its number, 0, 1, 2, ... `value` is cut to a 32-bit integer.
    double seed(double value);
    /// The next number of a stream, in [0, 1]; empty for a number that is no stream's.
    std::optional<double> next(double stream);

  private:
    std::vector<std::uint32_t> states_;
};

}  // namespace isoscope
