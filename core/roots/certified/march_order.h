// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace isoscope {

/// The least of the `errors` of those rows whose `lines` are not negative; the largest number without any.
double leastError(const double* lines, const double* errors, std::size_t count);

/// Puts lines whose enclosures leave open about the same next to each other, so that a batch of them can do
/// without the same small terms (TapeApproximation). Keeps its memory.
class MarchOrder {
  public:
    /// The rows of a table whose `lines` are not negative, the largest `errors` first: by powers of 2
    /// between 2^-63 and 2^31, and in their order within one. Errors are not negative. Holds until the next
    /// call.
    std::span<const std::uint32_t> sort(const double* lines, const double* errors, std::size_t count);

  private:
    std::array<std::uint32_t, 96> starts_;  ///< by the exponent of the error
    std::vector<std::uint32_t> rows_;
};

}  // namespace isoscope
