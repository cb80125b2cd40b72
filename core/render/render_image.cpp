// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/render_image.h"

#include <algorithm>
#include <mutex>
#include <new>
#include <utility>

#include "core/render/picture.h"
#include "core/render/tile_work_pool.h"
#include "core/render/worker_pool.h"

namespace isoscope {

namespace {

constexpr int tileSize = 32;

int tilesAcross(int pixels) { return (pixels + tileSize - 1) / tileSize; }

/// The pixels of tile number `index`.
void tilePixels(const Picture& picture, std::size_t index, std::vector<PixelIndex>& pixels) {
    const RenderRequest& request = picture.request();
    const auto across = static_cast<std::size_t>(tilesAcross(request.width));
    const int left = static_cast<int>(index % across) * tileSize;
    const int top = static_cast<int>(index / across) * tileSize;
    pixels.clear();
    visitCells(std::min(tileSize, request.width - left), std::min(tileSize, request.height - top),
               picture.pixelOrder(), [&](int column, int row) {
                   pixels.push_back({left + column, top + row});
               });
}

void drawTile(const Picture& picture, std::size_t index, Image& image, TileWork& work,
              const std::function<bool()>& stopped) {
    tilePixels(picture, index, work.pixels);
    if (!picture.draw(picture.request().antialias, work, stopped)) return;
    for (std::size_t i = 0; i < work.pixels.size(); ++i)
        image.pixels[static_cast<std::size_t>(work.pixels[i].y) * static_cast<std::size_t>(image.width) +
                     static_cast<std::size_t>(work.pixels[i].x)] = work.colors[i];
}

/// Draws all tiles of `picture` into `image`, which has its size.
void drawTiles(const Picture& picture, int threads, std::stop_token stop, Image& image,
               RenderStatistics& sum) {
    std::mutex sumMutex;
    TileWorkPool works(picture);
    const std::function<bool()> stopped = [&stop] { return stop.stop_requested(); };
    const auto count = static_cast<std::size_t>(tilesAcross(image.width)) *
                       static_cast<std::size_t>(tilesAcross(image.height));
    WorkerPool(threads).run(count, [&](std::size_t index) {
        if (stopped()) return;
        const TileWorkPool::Loan work = works.take(RayOrder::neighbours, stop);
        drawTile(picture, index, image, *work, stopped);
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
