// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/render_image.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <cstring>
#include <mutex>
#include <new>
#include <span>
#include <utility>

#include "core/render/picture.h"
#include "core/render/pixel_colors.h"
#include "core/render/tile_work_pool.h"
#include "core/render/worker_pool.h"

namespace isoscope {

namespace {

/// POV-Ray's are as large, which shows where its pixels depend on those before.
constexpr int tileHeight = 32;
/// Fewer tiles cost less where nothing depends on it: each has its clocks and sums.
constexpr int narrowTile = 32, wideTile = 64;

int tilesAcross(int pixels, int side) { return (pixels + side - 1) / side; }

/// The cells of a tile in the order in which they are drawn: a square of them after the other, since rays
/// that go through the stages together had better be close.
std::vector<PixelIndex> cellsOf(int columns, int rows, PixelOrder order) {
    std::vector<PixelIndex> cells;
    for (int left = 0; left < columns; left += narrowTile)
        visitCells(std::min(narrowTile, columns - left), rows, order, [&](int column, int row) {
            cells.push_back({left + column, row});
        });
    return cells;
}

/// A tile that the picture does not cut.
struct WholeTile {
    explicit WholeTile(PixelOrder pixelOrder)
        : order(pixelOrder),
          width(order == PixelOrder::rows ? narrowTile : wideTile),
          cells(cellsOf(width, tileHeight, order)) {}

    PixelOrder order;
    int width;
    std::vector<PixelIndex> cells;
};

/// The pixels of tile number `index`; `whole` is one that the picture does not cut.
void tilePixels(const Picture& picture, std::size_t index, const WholeTile& whole,
                std::vector<PixelIndex>& pixels) {
    const RenderRequest& request = picture.request();
    const auto across = static_cast<std::size_t>(tilesAcross(request.width, whole.width));
    const int left = static_cast<int>(index % across) * whole.width;
    const int top = static_cast<int>(index / across) * tileHeight;
    const int columns = std::min(whole.width, request.width - left);
    const int rows = std::min(tileHeight, request.height - top);
    const bool cut = columns != whole.width || rows != tileHeight;
    std::vector<PixelIndex> own;
    if (cut) own = cellsOf(columns, rows, picture.pixelOrder());
    const std::span<const PixelIndex> cells = cut ? own : whole.cells;
    pixels.resize(cells.size());
    placePixels(cells, {left, top}, pixels);
}

LinearColor* rowOf(Image& image, const PixelIndex& corner, int y) {
    return &image.pixels[static_cast<std::size_t>(corner.y + y) * static_cast<std::size_t>(image.width) +
                         static_cast<std::size_t>(corner.x)];
}

/// Has the part of the picture that a whole tile covers fetched while the tile is drawn: it is too far apart
/// in memory for the processor to foresee.
void fetchWhole(const WholeTile& whole, const PixelIndex& corner, Image& image) {
    constexpr std::ptrdiff_t cacheLine = 64;
    const auto bytes = static_cast<std::ptrdiff_t>(whole.width * static_cast<int>(sizeof(LinearColor)));
    for (int y = 0; y < tileHeight; ++y) {
        const auto* const row = reinterpret_cast<const std::byte*>(rowOf(image, corner, y));
        for (std::ptrdiff_t k = 0; k < bytes; k += cacheLine) hwy::Prefetch(row + k);
    }
}

/// The pixels of a tile drawn row by row.
void writeRows(const TileWork& work, Image& image) {
    for (std::size_t first = 0; first < work.pixels.size(); first += narrowTile)
        std::memcpy(rowOf(image, work.pixels[first], 0), &work.colors[first],
                    narrowTile * sizeof(LinearColor));
}

void writePixels(const WholeTile& whole, const TileWork& work, Image& image) {
    if (work.pixels.size() == whole.cells.size())
        return whole.order == PixelOrder::rows ? writeRows(work, image)
                                               : writeSquares(work.pixels, work.colors, image);
    LinearColor* const pixels = image.pixels.data();
    const auto width = static_cast<std::ptrdiff_t>(image.width);
    for (std::size_t i = 0; i < work.pixels.size(); ++i)
        pixels[work.pixels[i].y * width + work.pixels[i].x] = work.colors[i];
}

void drawTile(const Picture& picture, std::size_t index, const WholeTile& whole, Image& image, TileWork& work,
              const std::function<bool()>& stopped) {
    tilePixels(picture, index, whole, work.pixels);
    if (work.pixels.size() == whole.cells.size()) fetchWhole(whole, work.pixels.front(), image);
    if (!picture.draw(picture.manySamples(), work, stopped)) return;
    writePixels(whole, work, image);
    work.finish();
}

/// Draws all tiles of `picture` into `image`, which has its size.
void drawTiles(const Picture& picture, int threads, std::stop_token stop, Image& image,
               RenderStatistics& sum) {
    std::mutex sumMutex;
    TileWorkPool works(picture);
    const std::function<bool()> stopped = [&stop] { return stop.stop_requested(); };
    const WholeTile whole(picture.pixelOrder());
    const auto count = static_cast<std::size_t>(tilesAcross(image.width, whole.width)) *
                       static_cast<std::size_t>(tilesAcross(image.height, tileHeight));
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
