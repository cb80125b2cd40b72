// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/accuracy/picture_time.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <unordered_set>
#include <vector>

#include "core/render/picture.h"
#include "core/render/progressive/block_passes.h"
#include "core/render/progressive/pixel_order.h"
#include "core/render/progressive/tile_scratch.h"

namespace isoscope {

namespace {

/// As renderImage() draws them.
constexpr int squareSide = 32;
/// Roots of x^3 = x + 1: their powers spread points over a square more evenly than chance does (M. Roberts,
/// "The unreasonable effectiveness of quasirandom sequences", 2018).
constexpr double plastic = 1.32471795724474602596;

/// The squares of a picture, in an order every beginning of which is spread evenly over it.
class SquareOrder {
  public:
    SquareOrder(int width, int height)
        : width_(width),
          height_(height),
          across_((width + squareSide - 1) / squareSide),
          down_((height + squareSide - 1) / squareSide) {}

    std::size_t count() const { return static_cast<std::size_t>(across_) * static_cast<std::size_t>(down_); }

    /// The next one; only while fewer than count() were taken.
    PixelRectangle next() {
        // The sequence meets the last few of many squares late: these are taken in turn.
        for (int attempt = 0; attempt < mostAttempts; ++attempt) {
            ++step_;
            const auto place = [this](double ratio, int cells) {
                const double share = std::fmod(0.5 + step_ * ratio, 1.0);
                return std::min(cells - 1, static_cast<int>(share * cells));
            };
            const std::size_t index = static_cast<std::size_t>(place(1 / (plastic * plastic), down_)) *
                                          static_cast<std::size_t>(across_) +
                                      static_cast<std::size_t>(place(1 / plastic, across_));
            if (taken_.insert(index).second) return square(index);
        }
        while (!taken_.insert(turn_).second) ++turn_;
        return square(turn_);
    }

  private:
    static constexpr int mostAttempts = 64;

    PixelRectangle square(std::size_t index) const {
        const int x = static_cast<int>(index % static_cast<std::size_t>(across_)) * squareSide,
                  y = static_cast<int>(index / static_cast<std::size_t>(across_)) * squareSide;
        return {x, y, std::min(squareSide, width_ - x), std::min(squareSide, height_ - y)};
    }

    int width_, height_, across_, down_;
    double step_ = 0;
    std::size_t turn_ = 0;
    std::unordered_set<std::size_t> taken_;
};

/// Draws single squares and times them.
class SquareTimer {
  public:
    SquareTimer(const RenderRequest& request, std::stop_token stop)
        : picture_(request), stop_(std::move(stop)), work_(picture_.makeWork()) {
        for (int i = 0; i < 5; ++i) {
            picture_.begin(work_, RayOrder::neighbours, stop_);
            work_.finish();
            clock_ = i == 0 ? work_.cpuSeconds() : std::min(clock_, work_.cpuSeconds());
        }
    }

    /// Processor seconds; less than 0 when it was stopped.
    double draw(const PixelRectangle& square) {
        picture_.begin(work_, RayOrder::neighbours, stop_);
        if (picture_.isEmpty(square.extent())) {
            work_.colors.assign(square.pixels(), picture_.emptiness());
        } else {
            work_.pixels.clear();
            visitCells(square.width, square.height, picture_.pixelOrder(), [&](int column, int row) {
                work_.pixels.push_back({square.x + column, square.y + row});
            });
            if (!picture_.draw(picture_.manySamples(), work_, [this] { return stop_.stop_requested(); }))
                return -1;
        }
        work_.finish();
        return stop_.stop_requested() ? -1 : std::max(0.0, work_.cpuSeconds() - clock_);
    }

  private:
    Picture picture_;
    std::stop_token stop_;
    TileScratch work_;
    double clock_ = 0;  ///< what it takes to look at the clock, which whole pictures do once a thread
};

/// Times for a pixel of each square, and what follows from them for all.
class Sample {
  public:
    explicit Sample(std::size_t squares) : squares_(squares) {}

    void add(double secondsPerPixel) {
        ++count_;
        const double away = secondsPerPixel - mean_;
        mean_ += away / static_cast<double>(count_);
        squaredAway_ += away * (secondsPerPixel - mean_);
    }
    std::size_t count() const { return count_; }

    PictureTime predict(double pixels, double setUp) const {
        PictureTime time;
        time.sampled = count_;
        time.squares = squares_;
        time.cpuSeconds = mean_ * pixels + setUp;
        // Two standard errors of a mean of so many out of so many.
        const auto n = static_cast<double>(count_);
        const double variance = count_ > 1 ? squaredAway_ / (n - 1) : mean_ * mean_;
        const double left = 1 - n / static_cast<double>(squares_);
        const double off = 2 * std::sqrt(variance / n * std::max(0.0, left)) * pixels;
        time.error = std::hypot(time.cpuSeconds > 0 ? off / time.cpuSeconds : 0, timingError);
        return time;
    }

  private:
    std::size_t squares_, count_ = 0;
    double mean_ = 0, squaredAway_ = 0;
};

PictureTime predict(const RenderRequest& request, const PictureTimeEffort& effort,
                    const std::stop_token& stop, const std::function<void(const PictureTime&)>& report) {
    constexpr std::size_t firstReport = 8;
    SquareTimer timer(request, stop);
    SquareOrder order(request.width, request.height);
    Sample sample(order.count());
    const double pixels = static_cast<double>(request.width) * request.height;
    const double begun = threadCpuSeconds();
    double setUp = 0;
    std::size_t nextReport = firstReport;
    PictureTime time;
    for (std::size_t i = 0; i < order.count(); ++i) {
        const PixelRectangle square = order.next();
        double seconds = timer.draw(square);
        if (i == 0 && seconds >= 0) {
            // The first one makes evaluators and touches memory, once a thread.
            const double again = timer.draw(square);
            setUp = std::max(0.0, seconds - again);
            seconds = std::min(seconds, again);
        }
        if (seconds < 0) return time;
        sample.add(seconds / static_cast<double>(square.pixels()));
        time = sample.predict(pixels, setUp);
        const double spent = threadCpuSeconds() - begun;
        const double wanted = spent > effort.seconds ? effort.lateError : effort.error;
        const bool enough = sample.count() >= effort.squares && time.error <= wanted;
        time.complete = i + 1 == order.count() || enough || spent > effort.mostSeconds;
        if (report && (time.complete || sample.count() >= nextReport)) {
            nextReport = sample.count() * 3 / 2;
            report(time);
        }
        if (time.complete) break;
    }
    return time;
}

}  // namespace

PictureTime predictPictureTime(const RenderRequest& asked, const PictureTimeEffort& effort,
                               std::stop_token stop, const std::function<void(const PictureTime&)>& report) {
    RenderRequest request = asked;
    request.verdicts = nullptr;
    if (!request.scene || request.width <= 0 || request.height <= 0) return {};
    try {
        return predict(request, effort, stop, report);
    } catch (const std::bad_alloc&) {
        return {};
    }
}

}  // namespace isoscope
