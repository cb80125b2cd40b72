// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/render_image.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <mutex>
#include <new>
#include <span>
#include <utility>

#include "core/render/camera/pixel_colors.h"
#include "core/render/picture.h"
#include "core/render/progressive/block_passes.h"
#include "core/render/progressive/tile_scratch_pool.h"
#include "core/render/progressive/worker_pool.h"

namespace isoscope {

namespace {

/// POV-Ray's are as large, which shows where its pixels depend on those before.
constexpr int narrowTile = 32;
/// Fewer tiles cost less where nothing depends on it: each has its clocks and sums.
constexpr int wideTile = 64;

int tilesAcross(int pixels, int side) { return (pixels + side - 1) / side; }

/// The cells of a tile in the order in which they are drawn: a square of them after the other, since rays
/// that go through the stages together cost less when they are close.
std::vector<PixelIndex> cellsOf(int columns, int rows, PixelOrder order) {
    std::vector<PixelIndex> cells;
    cells.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    for (int top = 0; top < rows; top += narrowTile)
        for (int left = 0; left < columns; left += narrowTile)
            visitCells(std::min(narrowTile, columns - left), std::min(narrowTile, rows - top), order,
                       [&](int column, int row) {
                           cells.push_back({left + column, top + row});
                       });
    return cells;
}

/// The squares that a picture is drawn in, row by row; the last of a row and of a column may be cut.
class Tiles {
  public:
    Tiles(PixelOrder order, int width, int height)
        : order_(order),
          width_(width),
          height_(height),
          side_(order == PixelOrder::rows ? narrowTile : wideTile),
          across_(tilesAcross(width, side_)),
          down_(tilesAcross(height, side_)) {
        const std::array<int, 2> columns{std::min(side_, width), width - (across_ - 1) * side_};
        const std::array<int, 2> rows{std::min(side_, height), height - (down_ - 1) * side_};
        for (std::size_t atRight = 0; atRight < 2; ++atRight)
            for (std::size_t atEnd = 0; atEnd < 2; ++atEnd)
                cells_[atRight][atEnd] = cellsOf(columns[atRight], rows[atEnd], order);
    }

    PixelOrder order() const { return order_; }
    std::size_t count() const { return static_cast<std::size_t>(across_) * static_cast<std::size_t>(down_); }

    /// Where tile number `index` lies.
    PixelRectangle operator[](std::size_t index) const {
        const int x = static_cast<int>(index) % across_ * side_,
                  y = static_cast<int>(index) / across_ * side_;
        return {x, y, std::min(side_, width_ - x), std::min(side_, height_ - y)};
    }

    /// The cells of tile number `index`: its pixels, as seen from its corner.
    std::span<const PixelIndex> cells(std::size_t index) const {
        const int column = static_cast<int>(index) % across_, row = static_cast<int>(index) / across_;
        return cells_[column + 1 == across_ ? 1 : 0][row + 1 == down_ ? 1 : 0];
    }

    /// Calls visit(square, first) for the squares of tile number `index` that are drawn one after the other:
    /// the cells of each begin with number `first`.
    template <class Visit>
    void visitSquares(std::size_t index, Visit visit) const {
        const PixelRectangle tile = (*this)[index];
        std::size_t first = 0;
        for (int top = 0; top < tile.height; top += narrowTile)
            for (int left = 0; left < tile.width; left += narrowTile) {
                const PixelRectangle square{tile.x + left, tile.y + top,
                                            std::min(narrowTile, tile.width - left),
                                            std::min(narrowTile, tile.height - top)};
                visit(square, first);
                first += square.pixels();
            }
    }

  private:
    PixelOrder order_;
    int width_, height_, side_, across_, down_;
    std::array<std::array<std::vector<PixelIndex>, 2>, 2> cells_;  ///< of tiles at the right, at the end
};

LinearColor* rowOf(Image& image, const PixelIndex& corner, int y) {
    return &image.pixels[static_cast<std::size_t>(corner.y + y) * static_cast<std::size_t>(image.width) +
                         static_cast<std::size_t>(corner.x)];
}

/// A tile's size; the last of its pixels is that at the other end, in any order.
int columnsOf(const TileScratch& work) { return work.pixels.back().x - work.pixels.front().x + 1; }
int rowsOf(const TileScratch& work) { return work.pixels.back().y - work.pixels.front().y + 1; }

/// Has the part of the picture that a tile covers fetched while the tile is drawn: it is too far apart in
/// memory for the processor to foresee.
void fetchPlaces(const TileScratch& work, Image& image) {
    constexpr std::ptrdiff_t cacheLine = 64;
    const auto bytes = static_cast<std::ptrdiff_t>(columnsOf(work) * static_cast<int>(sizeof(LinearColor)));
    for (int y = 0; y < rowsOf(work); ++y) {
        const auto* const row = reinterpret_cast<const std::byte*>(rowOf(image, work.pixels.front(), y));
        for (std::ptrdiff_t k = 0; k < bytes; k += cacheLine) hwy::Prefetch(row + k);
    }
}

void writePixels(PixelOrder order, const TileScratch& work, Image& image) {
    if (order == PixelOrder::squares && columnsOf(work) % 4 == 0 && rowsOf(work) % 4 == 0)
        return writeSquares(work.pixels, work.colors, image);
    LinearColor* const pixels = image.pixels.data();
    const auto width = static_cast<std::ptrdiff_t>(image.width);
    for (std::size_t i = 0; i < work.pixels.size(); ++i)
        pixels[work.pixels[i].y * width + work.pixels[i].x] = work.colors[i];
}

/// Row by row from one that is filled already.
void fillEmpty(const Picture& picture, const PixelRectangle& tile, Image& image, TileScratch& work) {
    work.startMeter();
    const PixelIndex corner{tile.x, tile.y};
    const std::span<LinearColor> first(rowOf(image, corner, 0), static_cast<std::size_t>(tile.width));
    fillPixels(picture.emptiness(), first);
    for (int y = 1; y < tile.height; ++y) std::copy(first.begin(), first.end(), rowOf(image, corner, y));
    picture.countEmpty(tile.pixels(), work);
    work.charge(StageKind::background);
}

/// Draws the cells of a tile, all of them or one of its squares.
void drawCells(const Picture& picture, std::span<const PixelIndex> cells, const PixelIndex& corner,
               PixelOrder order, Image& image, TileScratch& work, const std::function<bool()>& stopped) {
    work.pixels.resize(cells.size());
    placePixels(cells, corner, work.pixels);
    fetchPlaces(work, image);
    if (picture.draw(picture.manySamples(), work, stopped)) writePixels(order, work, image);
}

void drawTile(const Picture& picture, std::size_t index, const Tiles& tiles, Image& image, TileScratch& work,
              const std::function<bool()>& stopped) {
    const PixelRectangle tile = tiles[index];
    const PixelIndex corner{tile.x, tile.y};
    if (picture.isEmpty(tile.extent())) return fillEmpty(picture, tile, image, work);
    const std::span<const PixelIndex> cells = tiles.cells(index);
    // Samples of a pixel may look at those of its neighbours.
    if (picture.manySamples()) {
        drawCells(picture, cells, corner, tiles.order(), image, work, stopped);
        return;
    }
    // One by one the squares take less memory, whose first touch has its price.
    tiles.visitSquares(index, [&](const PixelRectangle& square, std::size_t first) {
        if (stopped()) return;
        if (picture.isEmpty(square.extent())) return fillEmpty(picture, square, image, work);
        drawCells(picture, cells.subspan(first, square.pixels()), corner, tiles.order(), image, work,
                  stopped);
    });
}

/// Draws all tiles of `picture` into `image`, which has its size.
void drawTiles(const Picture& picture, int threads, std::stop_token stop, Image& image,
               RenderStatistics& sum) {
    std::mutex sumMutex;
    TileScratchPool works(picture);
    const std::function<bool()> stopped = [&stop] { return stop.stop_requested(); };
    const Tiles tiles(picture.pixelOrder(), image.width, image.height);
    std::atomic<std::size_t> next{0};
    WorkerPool pool(threads);
    // Each thread draws what comes next, and counts once what all of that has cost: to read the clock of CPU
    // time takes as long as a good part of a simple tile.
    pool.run(static_cast<std::size_t>(pool.threads()), [&](std::size_t) {
        std::size_t index = next++;
        if (index >= tiles.count() || stopped()) return;
        const TileScratchPool::Loan work = works.take(RayOrder::neighbours, stop);
        for (; index < tiles.count() && !stopped(); index = next++) {
            work->context.restart();
            drawTile(picture, index, tiles, image, *work, stopped);
            const std::lock_guard lock(sumMutex);
            picture.collectGradients(*work, sum);
        }
        work->finish();
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
