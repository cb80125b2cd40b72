// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/render_image.h"

#include <algorithm>
#include <mutex>
#include <new>
#include <span>
#include <utility>

#include "core/render/picture.h"
#include "core/render/tile_work_pool.h"
#include "core/render/worker_pool.h"

namespace isoscope {

namespace {

constexpr int tileSize = 32;

int tilesAcross(int pixels) { return (pixels + tileSize - 1) / tileSize; }

/// The cells of a tile in the order in which they are drawn.
std::vector<PixelIndex> cellsOf(int columns, int rows, PixelOrder order) {
    std::vector<PixelIndex> cells;
    visitCells(columns, rows, order, [&](int column, int row) { cells.push_back({column, row}); });
    return cells;
}

/// The pixels of tile number `index`; `whole` are the cells of a tile that the picture does not cut.
void tilePixels(const Picture& picture, std::size_t index, std::span<const PixelIndex> whole,
                std::vector<PixelIndex>& pixels) {
    const RenderRequest& request = picture.request();
    const auto across = static_cast<std::size_t>(tilesAcross(request.width));
    const int left = static_cast<int>(index % across) * tileSize;
    const int top = static_cast<int>(index / across) * tileSize;
    const int columns = std::min(tileSize, request.width - left);
    const int rows = std::min(tileSize, request.height - top);
    const bool cut = columns != tileSize || rows != tileSize;
    std::vector<PixelIndex> own;
    if (cut) own = cellsOf(columns, rows, picture.pixelOrder());
    const std::span<const PixelIndex> cells = cut ? own : whole;
    pixels.resize(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i) pixels[i] = {left + cells[i].x, top + cells[i].y};
}

void drawTile(const Picture& picture, std::size_t index, std::span<const PixelIndex> whole, Image& image,
              TileWork& work, const std::function<bool()>& stopped) {
    tilePixels(picture, index, whole, work.pixels);
    if (!picture.draw(picture.manySamples(), work, stopped)) return;
    LinearColor* const pixels = image.pixels.data();
    const auto width = static_cast<std::ptrdiff_t>(image.width);
    for (std::size_t i = 0; i < work.pixels.size(); ++i)
        pixels[work.pixels[i].y * width + work.pixels[i].x] = work.colors[i];
    work.finish();
}

/// Draws all tiles of `picture` into `image`, which has its size.
void drawTiles(const Picture& picture, int threads, std::stop_token stop, Image& image,
               RenderStatistics& sum) {
    std::mutex sumMutex;
    TileWorkPool works(picture);
    const std::function<bool()> stopped = [&stop] { return stop.stop_requested(); };
    const auto count = static_cast<std::size_t>(tilesAcross(image.width)) *
                       static_cast<std::size_t>(tilesAcross(image.height));
    const std::vector<PixelIndex> whole = cellsOf(tileSize, tileSize, picture.pixelOrder());
    WorkerPool(threads).run(count, [&](std::size_t index) {
        if (stopped()) return;
        const TileWorkPool::Loan work = works.take(RayOrder::neighbours, stop);
        drawTile(picture, index, whole, image, *work, stopped);
        const std::lock_guard lock(sumMutex);
        picture.collect(*work, sum);
    });
}

}  // namespace

Image renderImage(const RenderRequest& request, int threads, RenderStatistics* statistics,
                  std::stop_token stop) {
    if (statistics) *statistics = {};
    if (!Picture::drawable(request)) return {};
    try {
        const Picture picture(request);
        Image image(request.width, request.height);
        RenderStatistics sum = picture.emptyStatistics();
        drawTiles(picture, threads, std::move(stop), image, sum);
        if (statistics) *statistics = std::move(sum);
        return image;
    } catch (const std::bad_alloc&) {
        return {};
    }
}

}  // namespace isoscope
