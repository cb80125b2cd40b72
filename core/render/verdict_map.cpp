// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/verdict_map.h"

#include <algorithm>
#include <array>

namespace isoscope {

namespace {

/// From good to bad.
constexpr std::array<Verdict, 5> order{Verdict::certifiedMiss, Verdict::certifiedHit, Verdict::gap,
                                       Verdict::budgetExceeded, Verdict::notCertified};

std::uint8_t codeOf(Verdict verdict) {
    return static_cast<std::uint8_t>(std::find(order.begin(), order.end(), verdict) - order.begin() + 1);
}

}  // namespace

VerdictMap::VerdictMap(int width, int height)
    : width_(std::max(width, 0)),
      height_(std::max(height, 0)),
      codes_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)) {}

void VerdictMap::note(int x, int y, Verdict verdict) {
    if (!holds(x, y)) return;
    // One thread alone draws a pixel; the atomic is for those who look on.
    std::atomic<std::uint8_t>& code =
        codes_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
    const std::uint8_t next = codeOf(verdict), before = code.load(std::memory_order_relaxed);
    if ((before & ~wallBit) < next)
        code.store(static_cast<std::uint8_t>(next | (before & wallBit)), std::memory_order_relaxed);
}

void VerdictMap::noteWall(int x, int y) {
    if (!holds(x, y)) return;
    codes_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)]
        .fetch_or(wallBit, std::memory_order_relaxed);
    hasWalls_.store(true, std::memory_order_relaxed);
}

std::uint8_t VerdictMap::code(int x, int y) const {
    if (!holds(x, y)) return 0;
    return codes_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                  static_cast<std::size_t>(x)]
        .load(std::memory_order_relaxed);
}

Verdict VerdictMap::at(int x, int y) const { return order[std::max<std::uint8_t>(rank(x, y), 1) - 1u]; }

}  // namespace isoscope
