// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/progressive/block_passes.h"

#include <algorithm>

namespace isoscope {

namespace {

constexpr int coarsestBlock = 8;
constexpr int smallestTile = 32;
constexpr int largestTile = 128;
/// A picture in one pass is not seen to grow, and larger tiles cost less.
constexpr int soleTile = 64;

/// Blocks are powers of two.
int firstOf(int p, int block) { return p & ~(block - 1); }

/// The pixel of a row that stands for the block of pixel `p`. At the right edge the middle may lie outside.
int middle(int p, int block, int length) { return std::min(firstOf(p, block) + block / 2, length - 1); }

/// The middle of a block of 2 would be its second pixel, which a middle of a block of 8 never is.
int sampleOf(int p, int block, int length) {
    return block == coarsestBlock ? middle(p, block, length) : firstOf(p, block);
}

}  // namespace

BlockPasses::BlockPasses(int width, int height, int finestBlock, int second, Which which)
    : width_(width), height_(height), least_(smallestTile) {
    if (finestBlock >= coarsestBlock) {
        blocks_ = {coarsestBlock};
    } else if (finestBlock >= 2) {
        blocks_ = {coarsestBlock, finestBlock >= 4 ? 4 : 2};
    } else {
        blocks_ = {coarsestBlock, second, 1};
    }
    if (which != Which::all) blocks_ = {blocks_.back()};
    if (which == Which::lastInLargeTiles) least_ = soleTile;
}

int BlockPasses::tileSide(std::size_t pass) const {
    return std::clamp(smallestTile * blocks_[pass], least_, largestTile);
}

std::size_t BlockPasses::tileCount(std::size_t pass) const {
    const int side = tileSide(pass);
    return static_cast<std::size_t>((width_ + side - 1) / side) *
           static_cast<std::size_t>((height_ + side - 1) / side);
}

PixelRectangle BlockPasses::tile(std::size_t pass, std::size_t index) const {
    const int side = tileSide(pass);
    const auto across = static_cast<std::size_t>((width_ + side - 1) / side);
    const int x = static_cast<int>(index % across) * side;
    const int y = static_cast<int>(index / across) * side;
    return {x, y, std::min(side, width_ - x), std::min(side, height_ - y)};
}

PixelIndex BlockPasses::sample(std::size_t pass, int x, int y) const {
    return {sampleOf(x, blocks_[pass], width_), sampleOf(y, blocks_[pass], height_)};
}

bool BlockPasses::drawnBefore(std::size_t pass, int x, int y) const {
    for (std::size_t earlier = 0; earlier < pass; ++earlier) {
        const PixelIndex drawn = sample(earlier, x, y);
        if (drawn.x == x && drawn.y == y) return true;
    }
    return false;
}

}  // namespace isoscope
