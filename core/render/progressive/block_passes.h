// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "core/render/picture.h"

namespace isoscope {

/// A rectangle of pixels; x to the right and y down, from the upper left corner of the picture.
struct PixelRectangle {
    int x = 0, y = 0, width = 0, height = 0;

    /// Its area, which may be more than an int holds.
    std::size_t pixels() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
    /// The outer edges, where pixel centres are at one half.
    SampleBatch::Extent extent() const {
        const auto place = [](int column, int row) {
            return SampleBatch::PixelPosition{static_cast<double>(column), static_cast<double>(row)};
        };
        return {place(x, y), place(x + width, y + height)};
    }
};

/// The passes of a progressive picture, as geometry: in each pass one pixel stands for a square block. The
/// pixels of coarse passes are kept; later passes draw only what is missing.
class BlockPasses {
  public:
    /// Which of the passes are drawn.
    enum class Which {
        all,
        last,
        lastInLargeTiles,  ///< for pictures that do not depend on their tiles
    };

    /// Blocks of 8, then `second` (2 or 4), then 1 pixels; `finestBlock` 2 or 4 ends with that one, 8 and
    /// above draws one coarse pass.
    BlockPasses(int width, int height, int finestBlock, int second = 2, Which which = Which::all);

    /// Passes are numbered from 0 to count() - 1, coarse to fine.
    std::size_t count() const { return blocks_.size(); }
    /// Side of the block that one pixel of the pass stands for, in pixels: 8, 4, 2 or 1.
    int block(std::size_t pass) const { return blocks_[pass]; }

    /// Tiles hold whole blocks and about a thousand samples, large ones four thousand.
    std::size_t tileCount(std::size_t pass) const;
    /// Tiles are numbered row by row; those at the right and lower edge are cut off at the picture's.
    PixelRectangle tile(std::size_t pass, std::size_t index) const;

    /// The pixel that stands for the block of (x, y): its middle, so that the picture does not shift as it
    /// sharpens.
    PixelIndex sample(std::size_t pass, int x, int y) const;
    /// Whether an earlier pass has drawn this pixel.
    bool drawnBefore(std::size_t pass, int x, int y) const;

  private:
    int tileSide(std::size_t pass) const;

    int width_;
    int height_;
    int least_;  ///< side of a tile
    std::vector<int> blocks_;
};

}  // namespace isoscope
