// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/progressive/progressive_job.h"

#include <algorithm>
#include <atomic>

#include "core/render/image.h"

namespace isoscope {

namespace {

BlockPasses passesOf(const Picture& picture, int finestBlock, bool onePass) {
    // Where the last pass has to draw everything anew, the one before must be cheap, and the picture is
    // that of its tiles.
    const bool orderMatters = picture.orderMatters();
    const auto last = orderMatters ? BlockPasses::Which::last : BlockPasses::Which::lastInLargeTiles;
    return {picture.request().width, picture.request().height, finestBlock, orderMatters ? 4 : 2,
            onePass ? last : BlockPasses::Which::all};
}

}  // namespace

ProgressiveJob::ProgressiveJob(std::uint64_t number, const Picture& picture, int finestBlock, bool onePass)
    : number_(number),
      picture_(picture),
      works_(picture),
      passes_(passesOf(picture, finestBlock, onePass)),
      pixels_(onePass ? 0
                      : static_cast<std::size_t>(picture.request().width) *
                            static_cast<std::size_t>(picture.request().height)) {}

bool ProgressiveJob::run(WorkerPool& pool, Listener& listener) {
    for (std::size_t pass = 0; pass < passes_.count(); ++pass) {
        if (!runPass(pass, pool, listener)) return false;
        listener.passDone();
    }
    return true;
}

bool ProgressiveJob::runPass(std::size_t pass, WorkerPool& pool, Listener& listener) {
    std::atomic<bool> complete{true};
    const std::stop_token stop = listener.passBegins(pass);
    pool.run(passes_.tileCount(pass), [&](std::size_t index) {
        if (complete && !drawTile(pass, passes_.tile(pass, index), stop, listener)) complete = false;
    });
    return complete;
}

bool ProgressiveJob::drawTile(std::size_t pass, const PixelRectangle& area, std::stop_token stop,
                              Listener& listener) {
    const TileScratchPool::Loan work =
        works_.take(drawsAnew(pass) ? RayOrder::neighbours : RayOrder::scattered, std::move(stop));
    FinishedTile tile{number_, area.x, area.y, area.width, area.height, {}};
    tile.pixels.resize(area.pixels());
    tile.block = passes_.block(pass);
    const bool drawn =
        onePass() ? drawWhole(area, *work, listener, tile) : drawMissing(pass, area, *work, listener, tile);
    if (!drawn) return false;
    work->finish();
    listener.tileDone(std::move(tile), picture_, *work);
    return true;
}

/// At once, at full resolution.
bool ProgressiveJob::drawWhole(const PixelRectangle& area, TileScratch& work, Listener& listener,
                               FinishedTile& tile) {
    if (picture_.isEmpty(area.extent())) {
        work.startMeter();
        std::fill(tile.pixels.begin(), tile.pixels.end(), encodePixel(picture_.emptiness()));
        picture_.countEmpty(area.pixels(), work);
        work.charge(StageKind::background);
        return true;
    }
    work.pixels.clear();
    visitCells(area.width, area.height, picture_.pixelOrder(), [&](int column, int row) {
        work.pixels.push_back({area.x + column, area.y + row});
    });
    if (!picture_.draw(picture_.manySamples(), work, [&] { return listener.letGo(0); })) return false;
    work.encoded.resize(work.colors.size());
    encodePixels(work.colors, work.encoded);
    for (std::size_t i = 0; i < work.pixels.size(); ++i) {
        const int place = (work.pixels[i].y - area.y) * area.width + work.pixels[i].x - area.x;
        tile.pixels[static_cast<std::size_t>(place)] = work.encoded[i];
    }
    return true;
}

/// What the passes before have not drawn.
bool ProgressiveJob::drawMissing(std::size_t pass, const PixelRectangle& area, TileScratch& work,
                                 Listener& listener, FinishedTile& tile) {
    findMissing(pass, area, work.pixels);
    const bool antialias = isFullResolution(pass) && picture_.manySamples();
    if (!picture_.draw(antialias, work, [&] { return listener.letGo(pass); })) return false;
    work.encoded.resize(work.colors.size());
    encodePixels(work.colors, work.encoded);
    for (std::size_t i = 0; i < work.pixels.size(); ++i)
        pixel(work.pixels[i].x, work.pixels[i].y) = work.encoded[i];
    fillBlocks(pass, tile);
    return true;
}

void ProgressiveJob::findMissing(std::size_t pass, const PixelRectangle& area,
                                 std::vector<PixelIndex>& pixels) const {
    pixels.clear();
    const int block = passes_.block(pass);
    const bool anew = drawsAnew(pass);
    const int columns = (area.width + block - 1) / block, rows = (area.height + block - 1) / block;
    visitCells(columns, rows, picture_.pixelOrder(), [&](int column, int row) {
        const PixelIndex sample = passes_.sample(pass, area.x + column * block, area.y + row * block);
        if (anew || !passes_.drawnBefore(pass, sample.x, sample.y)) pixels.push_back(sample);
    });
}

/// Every block of the tile gets the colour of the pixel that stands for it.
void ProgressiveJob::fillBlocks(std::size_t pass, FinishedTile& tile) const {
    const auto width = static_cast<std::size_t>(picture_.request().width);
    std::uint32_t* to = tile.pixels.data();
    for (int y = tile.y; y < tile.y + tile.height; ++y) {
        for (int x = tile.x; x < tile.x + tile.width; ++x) {
            const PixelIndex sample = passes_.sample(pass, x, y);
            *to++ = pixels_[static_cast<std::size_t>(sample.y) * width + static_cast<std::size_t>(sample.x)];
        }
    }
}

bool ProgressiveJob::drawsAnew(std::size_t pass) const {
    return isFullResolution(pass) && (picture_.manySamples() || picture_.orderMatters());
}

std::uint32_t& ProgressiveJob::pixel(int x, int y) {
    return pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(picture_.request().width) +
                   static_cast<std::size_t>(x)];
}

}  // namespace isoscope
