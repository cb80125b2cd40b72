// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/picture_buffer.h"

#include <algorithm>
#include <cstddef>

namespace isoscope {

namespace {

bool wellFormed(const FinishedTile& tile) {
    return tile.width > 0 && tile.height > 0 &&
           tile.pixels.size() >= static_cast<std::size_t>(tile.width) * static_cast<std::size_t>(tile.height);
}

void copyTile(const FinishedTile& tile, QImage& image) {
    const QRect area = QRect(tile.x, tile.y, tile.width, tile.height) & image.rect();
    if (!wellFormed(tile)) return;
    for (int y = area.top(); y <= area.bottom(); ++y) {
        const std::uint32_t* from =
            tile.pixels.data() + std::ptrdiff_t{y - tile.y} * tile.width + (area.left() - tile.x);
        std::copy_n(from, area.width(), reinterpret_cast<std::uint32_t*>(image.scanLine(y)) + area.left());
    }
}

/// Between two colours, 256 steps; all channels at once.
std::uint32_t between(std::uint32_t a, std::uint32_t b, std::uint32_t step) {
    constexpr std::uint32_t odd = 0xff00ff, even = 0x00ff00;
    const std::uint32_t first = ((a & odd) * (256 - step) + (b & odd) * step) >> 8;
    const std::uint32_t second = ((a & even) * (256 - step) + (b & even) * step) >> 8;
    return 0xff000000u | (first & odd) | (second & even);
}

/// Where a pixel lies between the middles of blocks, in 256ths of a block.
int gridPlace(int pixel, int block, int count) {
    return std::clamp(((2 * pixel + 1) * 128) / block - 128, 0, (count - 1) * 256);
}

}  // namespace

void PictureBuffer::expect(std::uint64_t job, QSize size, Reveal reveal) {
    expected_.push_back({job, size, reveal});
}

void PictureBuffer::clear() { *this = PictureBuffer(); }

bool PictureBuffer::start(std::uint64_t job) {
    while (!expected_.empty() && expected_.front().number < job) expected_.pop_front();
    if (expected_.empty() || expected_.front().number != job || expected_.front().size.isEmpty())
        return false;
    buildingJob_ = expected_.front();
    expected_.pop_front();
    building_ = QImage(buildingJob_.size, QImage::Format_RGB32);
    building_.fill(Qt::black);
    covered_ = 0;
    return true;
}

void PictureBuffer::begin(const FinishedTile& tile, const QImage& image) {
    if (grid_.job == tile.job && grid_.block == tile.block && !grid_.colors.empty()) return;
    grid_ = {tile.job,
             tile.block,
             (image.width() + tile.block - 1) / tile.block,
             (image.height() + tile.block - 1) / tile.block,
             {},
             {},
             {}};
    for (int x = 0; x < image.width(); ++x) {
        const auto place = static_cast<std::uint32_t>(gridPlace(x, grid_.block, grid_.columns));
        grid_.left.push_back(place / 256);
        grid_.step.push_back(place % 256);
    }
    // Blocks that are not there yet look as the picture does so far.
    grid_.colors.reserve(static_cast<std::size_t>(grid_.columns) * static_cast<std::size_t>(grid_.rows));
    for (int row = 0; row < grid_.rows; ++row) {
        const int y = std::min(row * tile.block + tile.block / 2, image.height() - 1);
        const auto* line = reinterpret_cast<const std::uint32_t*>(image.constScanLine(y));
        for (int column = 0; column < grid_.columns; ++column)
            grid_.colors.push_back(line[std::min(column * tile.block + tile.block / 2, image.width() - 1)]);
    }
}

void PictureBuffer::note(const FinishedTile& tile) {
    for (int y = 0; y < tile.height; y += tile.block)
        for (int x = 0; x < tile.width; x += tile.block) {
            const int column = (tile.x + x) / tile.block, row = (tile.y + y) / tile.block;
            if (tile.x < 0 || tile.y < 0 || column >= grid_.columns || row >= grid_.rows) continue;
            grid_.colors[static_cast<std::size_t>(row) * static_cast<std::size_t>(grid_.columns) +
                         static_cast<std::size_t>(column)] =
                tile.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(tile.width) +
                            static_cast<std::size_t>(x)];
        }
}

void PictureBuffer::drawSmoothly(const QRect& area, QImage& image) {
    const QRect inside = area & image.rect();
    if (inside.isEmpty()) return;
    const auto columns = static_cast<std::size_t>(grid_.columns);
    row_.resize(columns + 1);
    const std::size_t first = grid_.left[static_cast<std::size_t>(inside.left())];
    const std::size_t last =
        std::min<std::size_t>(grid_.left[static_cast<std::size_t>(inside.right())] + 1, columns - 1);
    for (int y = inside.top(); y <= inside.bottom(); ++y) {
        const int place = gridPlace(y, grid_.block, grid_.rows);
        const auto above = static_cast<std::size_t>(place / 256);
        const std::size_t below = std::min(above + 1, static_cast<std::size_t>(grid_.rows - 1));
        for (std::size_t column = first; column <= last; ++column)
            row_[column] =
                between(grid_.colors[above * columns + column], grid_.colors[below * columns + column],
                        static_cast<std::uint32_t>(place % 256));
        row_[last + 1] = row_[last];
        auto* line = reinterpret_cast<std::uint32_t*>(image.scanLine(y));
        for (auto x = static_cast<std::size_t>(inside.left()); x <= static_cast<std::size_t>(inside.right());
             ++x)
            line[x] = between(row_[grid_.left[x]], row_[grid_.left[x] + 1], grid_.step[x]);
    }
}

bool PictureBuffer::reveal() {
    const qint64 area = static_cast<qint64>(building_.width()) * building_.height();
    if (building_.isNull() || covered_ < area) return false;
    if (grid_.job == buildingJob_.number && covered_ == area) drawSmoothly(building_.rect(), building_);
    shown_ = std::move(building_);
    building_ = {};
    shownJob_ = buildingJob_.number;
    return true;
}

bool PictureBuffer::add(const std::vector<FinishedTile>& tiles) {
    bool changed = false;
    for (const FinishedTile& tile : tiles) {
        if (tile.job != 0 && tile.job == shownJob_) {
            if (tile.block > 1 && wellFormed(tile)) {
                begin(tile, shown_);
                note(tile);
                drawSmoothly({tile.x, tile.y, tile.width, tile.height}, shown_);
            } else {
                copyTile(tile, shown_);
            }
            changed = true;
            continue;
        }
        if (tile.job < shownJob_) continue;
        if ((building_.isNull() || tile.job != buildingJob_.number) && !start(tile.job)) continue;
        if (tile.block > 1 && wellFormed(tile)) {
            begin(tile, building_);
            note(tile);
        }
        copyTile(tile, building_);
        covered_ += static_cast<qint64>(tile.width) * tile.height;
        if (buildingJob_.reveal == Reveal::firstPass) changed |= reveal();
    }
    return changed;
}

bool PictureBuffer::complete(std::uint64_t job) { return job != 0 && job == buildingJob_.number && reveal(); }

}  // namespace isoscope
