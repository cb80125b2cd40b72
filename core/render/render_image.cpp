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
/// Pictures up to this size are one strip. The first touch of larger ones takes longer than their threads
/// wait for each other in between: landscape, 3840 x 2160, all but drawing 16.4 % with 2^22 and 13.4 % with
/// 2^20.
constexpr std::int64_t stripPixels = std::int64_t{1} << 20;

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
    /// Of a strip of the picture that begins with row `top`, where a whole tile does.
    Tiles(PixelOrder order, int width, int height, int top)
        : order_(order),
          width_(width),
          height_(height),
          top_(top),
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
        return {x, top_ + y, std::min(side_, width_ - x), std::min(side_, height_ - y)};
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
    int width_, height_, top_, side_, across_, down_;
    std::array<std::array<std::vector<PixelIndex>, 2>, 2> cells_;  ///< of tiles at the right, at the end
};

/// Rows of a picture from `top` on.
struct Strip {
    Image image;
    int top = 0;

    std::size_t place(const PixelIndex& pixel) const {
        return static_cast<std::size_t>(pixel.y - top) * static_cast<std::size_t>(image.width) +
               static_cast<std::size_t>(pixel.x);
    }
};

LinearColor* rowOf(Strip& strip, const PixelIndex& corner, int y) {
    return &strip.image.pixels[strip.place({corner.x, corner.y + y})];
}

/// A tile's size; the last of its pixels is that at the other end, in any order.
int columnsOf(const TileScratch& work) { return work.pixels.back().x - work.pixels.front().x + 1; }
int rowsOf(const TileScratch& work) { return work.pixels.back().y - work.pixels.front().y + 1; }

/// Has the part of the picture that a tile covers fetched while the tile is drawn: it is too far apart in
/// memory for the processor to foresee.
void fetchPlaces(const TileScratch& work, Strip& strip) {
    constexpr std::ptrdiff_t cacheLine = 64;
    const auto bytes = static_cast<std::ptrdiff_t>(columnsOf(work) * static_cast<int>(sizeof(LinearColor)));
    for (int y = 0; y < rowsOf(work); ++y) {
        const auto* const row = reinterpret_cast<const std::byte*>(rowOf(strip, work.pixels.front(), y));
        for (std::ptrdiff_t k = 0; k < bytes; k += cacheLine) hwy::Prefetch(row + k);
    }
}

void writePixels(PixelOrder order, TileScratch& work, Strip& strip) {
    if (!strip.image.opacity.empty())
        for (std::size_t i = 0; i < work.pixels.size(); ++i)
            strip.image.opacity[strip.place(work.pixels[i])] = work.opacity[i];
    if (strip.top > 0)
        for (PixelIndex& pixel : work.pixels) pixel.y -= strip.top;
    if (order == PixelOrder::squares && columnsOf(work) % 4 == 0 && rowsOf(work) % 4 == 0)
        return writeSquares(work.pixels, work.colors, strip.image);
    LinearColor* const pixels = strip.image.pixels.data();
    const auto width = static_cast<std::ptrdiff_t>(strip.image.width);
    for (std::size_t i = 0; i < work.pixels.size(); ++i)
        pixels[work.pixels[i].y * width + work.pixels[i].x] = work.colors[i];
}

/// Row by row from one that is filled already.
void fillEmpty(const Picture& picture, const PixelRectangle& tile, Strip& strip, TileScratch& work) {
    work.startMeter();
    const PixelIndex corner{tile.x, tile.y};
    const std::span<LinearColor> first(rowOf(strip, corner, 0), static_cast<std::size_t>(tile.width));
    fillPixels(picture.emptiness(), first);
    for (int y = 1; y < tile.height; ++y) std::copy(first.begin(), first.end(), rowOf(strip, corner, y));
    picture.countEmpty(tile.pixels(), work);
    work.charge(StageKind::background);
}

/// Draws the cells of a tile, all of them or one of its squares.
void drawCells(const Picture& picture, std::span<const PixelIndex> cells, const PixelIndex& corner,
               PixelOrder order, Strip& strip, TileScratch& work, const std::function<bool()>& stopped) {
    work.pixels.resize(cells.size());
    placePixels(cells, corner, work.pixels);
    fetchPlaces(work, strip);
    if (picture.draw(picture.manySamples(), work, stopped)) writePixels(order, work, strip);
}

void drawTile(const Picture& picture, std::size_t index, const Tiles& tiles, Strip& strip, TileScratch& work,
              const std::function<bool()>& stopped) {
    const PixelRectangle tile = tiles[index];
    const PixelIndex corner{tile.x, tile.y};
    if (picture.isEmpty(tile.extent())) return fillEmpty(picture, tile, strip, work);
    const std::span<const PixelIndex> cells = tiles.cells(index);
    // Samples of a pixel may look at those of its neighbours.
    if (picture.manySamples()) {
        drawCells(picture, cells, corner, tiles.order(), strip, work, stopped);
        return;
    }
    // One by one the squares take less memory, whose first touch has its price.
    tiles.visitSquares(index, [&](const PixelRectangle& square, std::size_t first) {
        if (stopped()) return;
        if (picture.isEmpty(square.extent())) return fillEmpty(picture, square, strip, work);
        drawCells(picture, cells.subspan(first, square.pixels()), corner, tiles.order(), strip, work,
                  stopped);
    });
}

/// What draws the tiles of a picture.
struct Workshop {
    const Picture& picture;
    WorkerPool& pool;
    TileScratchPool& works;
    RenderStatistics& sum;
};

/// Draws all tiles of `strip`, whose image has its size. `done` is told the share of them that is drawn.
void drawTiles(const Workshop& shop, std::stop_token stop, Strip& strip,
               const std::function<void(double)>& done) {
    std::mutex sumMutex;
    const std::function<bool()> stopped = [&stop] { return stop.stop_requested(); };
    const Tiles tiles(shop.picture.pixelOrder(), strip.image.width, strip.image.height, strip.top);
    std::atomic<std::size_t> next{0};
    std::size_t drawn = 0;
    // Each thread draws what comes next, and counts once what all of that has cost: to read the clock of CPU
    // time takes as long as a good part of a simple tile.
    shop.pool.run(static_cast<std::size_t>(shop.pool.threads()), [&](std::size_t) {
        std::size_t index = next++;
        if (index >= tiles.count() || stopped()) return;
        const TileScratchPool::Loan work = shop.works.take(RayOrder::neighbours, stop);
        for (; index < tiles.count() && !stopped(); index = next++) {
            work->context.restart();
            drawTile(shop.picture, index, tiles, strip, *work, stopped);
            const std::lock_guard lock(sumMutex);
            shop.picture.collectGradients(*work, shop.sum);
            if (done) done(static_cast<double>(++drawn) / static_cast<double>(tiles.count()));
        }
        work->finish();
        const std::lock_guard lock(sumMutex);
        shop.picture.collect(*work, shop.sum);
    });
}

Image emptyImage(const RenderRequest& request, int rows) {
    Image image(request.width, rows);
    if (request.transparent) image.opacity.assign(image.pixels.size(), 0);
    return image;
}

}  // namespace

Image renderImage(const RenderRequest& request, int threads, RenderStatistics* statistics,
                  std::stop_token stop) {
    if (statistics) *statistics = {};
    if (!Picture::drawable(request)) return {};
    try {
        const Picture picture(request);
        Strip whole{emptyImage(request, request.height)};
        RenderStatistics sum = picture.emptyStatistics();
        TileScratchPool works(picture);
        WorkerPool pool(threads);
        drawTiles({picture, pool, works, sum}, std::move(stop), whole, {});
        if (statistics) *statistics = std::move(sum);
        return std::move(whole.image);
    } catch (const std::bad_alloc&) {
        return {};
    }
}

struct StripRenderer::Implementation {
    Implementation(const RenderRequest& request, int threads)
        : picture(request), pool(threads), works(picture), sum(picture.emptyStatistics()) {}

    Picture picture;
    WorkerPool pool;
    TileScratchPool works;
    RenderStatistics sum;
    int next = 0;
};

StripRenderer::StripRenderer(const RenderRequest& request, int threads) {
    try {
        if (drawable(request)) implementation_ = std::make_unique<Implementation>(request, threads);
    } catch (const std::bad_alloc&) {
        // Nothing is drawn then.
    }
}

StripRenderer::~StripRenderer() = default;

bool StripRenderer::drawable(const RenderRequest& request) {
    return request.scene && request.width > 0 && request.height > 0 && request.width <= longestSide &&
           request.height <= longestSide;
}

int StripRenderer::stripRows() const {
    if (!implementation_) return 0;
    const RenderRequest& request = implementation_->picture.request();
    const auto rows = static_cast<int>(stripPixels / request.width) / wideTile * wideTile;
    return std::min(std::max(rows, wideTile), request.height);
}

int StripRenderer::nextRow() const { return implementation_ ? implementation_->next : 0; }

Image StripRenderer::next(std::stop_token stop, const Report& report) {
    if (!implementation_) return {};
    Implementation& own = *implementation_;
    const RenderRequest& request = own.picture.request();
    const int rows = std::min(stripRows(), request.height - own.next);
    if (rows <= 0) return {};
    try {
        Strip strip{emptyImage(request, rows), own.next};
        const double height = request.height;
        const auto done = [&, from = own.next / height, share = rows / height](double part) {
            if (report) report(from + part * share);
        };
        drawTiles({own.picture, own.pool, own.works, own.sum}, std::move(stop), strip, done);
        own.next += rows;
        return std::move(strip.image);
    } catch (const std::bad_alloc&) {
        return {};
    }
}

const RenderStatistics& StripRenderer::statistics() const {
    static const RenderStatistics none;
    return implementation_ ? implementation_->sum : none;
}

}  // namespace isoscope
