// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "core/roots/verdict.h"

namespace isoscope {

/// What is certain about each pixel of a picture. Written by the threads that draw it, and readable
/// meanwhile.
class VerdictMap {
  public:
    /// Nothing is noted yet. Sizes below 1 make an empty map.
    VerdictMap(int width, int height);

    /// In pixels; 0 for an empty map.
    int width() const { return width_; }
    int height() const { return height_; }
    /// The worst verdict of a pixel stays; a hit among misses is a hit. Places outside are left out.
    void note(int x, int y, Verdict verdict);
    bool noted(int x, int y) const { return rank(x, y) != 0; }
    /// The pixel shows the wall of a container. Noted for good.
    void noteWall(int x, int y);
    bool wall(int x, int y) const { return (code(x, y) & wallBit) != 0; }
    /// Whether any pixel does.
    bool hasWalls() const { return hasWalls_.load(std::memory_order_relaxed); }
    /// certifiedMiss where nothing is noted.
    Verdict at(int x, int y) const;

  private:
    static constexpr std::uint8_t wallBit = 0x80;

    bool holds(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }
    std::uint8_t code(int x, int y) const;
    std::uint8_t rank(int x, int y) const { return code(x, y) & static_cast<std::uint8_t>(~wallBit); }

    int width_;
    int height_;
    std::vector<std::atomic<std::uint8_t>> codes_;  ///< rank + 1; 0 for nothing
    std::atomic<bool> hasWalls_ = false;
};

}  // namespace isoscope
