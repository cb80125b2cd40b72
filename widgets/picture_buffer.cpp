// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/picture_buffer.h"

#include <algorithm>
#include <cstring>

namespace isoscope {

namespace {

void copyTile(const FinishedTile& tile, QImage& image) {
    const QRect area = QRect(tile.x, tile.y, tile.width, tile.height) & image.rect();
    if (tile.pixels.size() < static_cast<std::size_t>(tile.width) * tile.height) return;
    for (int y = area.top(); y <= area.bottom(); ++y) {
        const std::uint32_t* from =
            tile.pixels.data() + static_cast<std::size_t>(y - tile.y) * tile.width + (area.left() - tile.x);
        std::memcpy(image.scanLine(y) + area.left() * sizeof(std::uint32_t), from,
                    area.width() * sizeof(std::uint32_t));
    }
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

bool PictureBuffer::reveal() {
    const qint64 area = static_cast<qint64>(building_.width()) * building_.height();
    if (building_.isNull() || covered_ < area) return false;
    shown_ = std::move(building_);
    building_ = {};
    shownJob_ = buildingJob_.number;
    return true;
}

bool PictureBuffer::add(const std::vector<FinishedTile>& tiles) {
    bool changed = false;
    for (const FinishedTile& tile : tiles) {
        if (tile.job != 0 && tile.job == shownJob_) {
            copyTile(tile, shown_);
            changed = true;
            continue;
        }
        if (tile.job < shownJob_) continue;
        if ((building_.isNull() || tile.job != buildingJob_.number) && !start(tile.job)) continue;
        copyTile(tile, building_);
        covered_ += static_cast<qint64>(tile.width) * tile.height;
        if (buildingJob_.reveal == Reveal::firstPass) changed |= reveal();
    }
    return changed;
}

bool PictureBuffer::complete(std::uint64_t job) { return job != 0 && job == buildingJob_.number && reveal(); }

}  // namespace isoscope
