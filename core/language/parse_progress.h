// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

namespace isoscope {

/// How far a parse has come, for another thread to look at while it runs.
struct ParseProgress {
    std::atomic<std::size_t> steps{0};  ///< tokens read and what counts as such, of ParseOptions::stepBudget
    std::atomic<std::uint32_t> place{0};  ///< byte of the user's own text that was read last
};

}  // namespace isoscope
