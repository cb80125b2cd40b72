// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/certified/march_order.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace isoscope {

namespace {

/// Of a number that is not negative, with larger ones first.
std::size_t rank(double error, std::size_t ranks) {
    constexpr std::uint64_t largest = 1023 + 31;  // 2^31 and more
    const std::uint64_t exponent = std::bit_cast<std::uint64_t>(error) >> 52;
    return static_cast<std::size_t>(
        std::min<std::uint64_t>(largest - std::min(exponent, largest), ranks - 1));
}

}  // namespace

double leastError(const double* lines, const double* errors, std::size_t count) {
    double least = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < count; ++i)
        if (lines[i] >= 0) least = std::min(least, errors[i]);
    return least;
}

std::span<const std::uint32_t> MarchOrder::sort(const double* lines, const double* errors,
                                                std::size_t count) {
    starts_.fill(0);
    for (std::size_t i = 0; i < count; ++i) starts_[rank(errors[i], starts_.size())] += lines[i] >= 0;
    std::uint32_t total = 0;
    for (std::uint32_t& start : starts_) {
        const std::uint32_t rows = start;
        start = total;
        total += rows;
    }
    rows_.resize(total);
    for (std::size_t i = 0; i < count; ++i)
        if (lines[i] >= 0) rows_[starts_[rank(errors[i], starts_.size())]++] = static_cast<std::uint32_t>(i);
    return rows_;
}

}  // namespace isoscope
