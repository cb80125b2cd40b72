// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/progressive_renderer.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "core/render/image.h"
#include "core/render/progressive_job.h"
#include "core/render/worker_pool.h"

namespace isoscope {

namespace {

using Clock = std::chrono::steady_clock;

/// The first pass of a job goes on after a stop request, but not for ever: a text that costs minutes must not
/// keep its own correction waiting.
constexpr std::chrono::milliseconds firstPassPatience{1500};

/// All cores, less one for the thread that paints where there are enough.
int defaultThreads(int threads) {
    if (threads > 0) return threads;
    const int cores = static_cast<int>(std::thread::hardware_concurrency());
    return cores > 2 ? cores - 1 : std::max(cores, 1);
}

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

struct ProgressiveRenderer::Implementation : ProgressiveJob::Listener {
    struct Order {
        std::uint64_t job = 0;
        RenderRequest request;
        int finestBlock = 1;
    };

    explicit Implementation(int threads)
        : pool(defaultThreads(threads)), coordinator([this](std::stop_token end) { coordinate(end); }) {}
    ~Implementation() override { abandon(); }

    std::uint64_t request(RenderRequest request, int finestBlock);
    void abandon();
    void coordinate(std::stop_token end);
    void run(const Order& order);
    bool isNewest() const { return running == progress.job; }

    std::stop_token passBegins(std::size_t pass) override;
    bool letGo(std::size_t pass) override;
    void tileDone(FinishedTile tile, const Picture& picture, const TileWork& work) override;
    void passDone() override;

    WorkerPool pool;

    mutable std::mutex mutex;  // guards what follows, down to the flags
    std::condition_variable_any wake;
    std::optional<Order> waiting;
    std::uint64_t running = 0;  ///< number of the running job, else 0
    RenderProgress progress;    ///< of the newest job
    Clock::time_point start;    ///< of the running job
    std::vector<FinishedTile> tiles;
    bool firstPass = true;  ///< the running job is in it
    std::stop_source stop;  ///< of the pass at hand

    std::atomic<bool> replaced{false};   ///< let go, but not before the first pass is done
    std::atomic<bool> abandoned{false};  ///< let go at once
    std::atomic<Clock::rep> replacedAt{0};

    std::jthread coordinator;  // last: ends first
};

std::uint64_t ProgressiveRenderer::Implementation::request(RenderRequest request, int finestBlock) {
    const std::lock_guard lock(mutex);
    const std::uint64_t job = progress.job + 1;
    RenderProgress begun;
    begun.job = job;
    begun.finished = false;
    if (Picture::drawable(request))
        begun.passCount = static_cast<int>(BlockPasses(request.width, request.height, finestBlock).count());
    progress = std::move(begun);
    waiting = Order{job, std::move(request), finestBlock};
    if (running != 0 && !replaced) {
        replacedAt = Clock::now().time_since_epoch().count();
        replaced = true;
        if (!firstPass) stop.request_stop();
    }
    wake.notify_one();
    return job;
}

void ProgressiveRenderer::Implementation::abandon() {
    const std::lock_guard lock(mutex);
    waiting.reset();
    if (running == 0) {
        progress.finished = true;
    } else {
        abandoned = true;
        stop.request_stop();
    }
}

void ProgressiveRenderer::Implementation::coordinate(std::stop_token end) {
    std::unique_lock lock(mutex);
    while (wake.wait(lock, end, [this] { return waiting.has_value(); })) {
        const Order order = std::move(*waiting);
        waiting.reset();
        running = order.job;
        replaced = abandoned = false;
        firstPass = true;
        stop = {};
        start = Clock::now();
        lock.unlock();
        run(order);
        lock.lock();
        if (isNewest()) {
            progress.seconds = secondsSince(start);
            progress.finished = true;
        }
        running = 0;
        // A job stopped by stop() while another waited leaves no one to say that all is over.
        if (!waiting) progress.finished = true;
    }
}

void ProgressiveRenderer::Implementation::run(const Order& order) {
    if (!Picture::drawable(order.request)) return;
    try {
        const Picture picture(order.request);
        {
            const std::lock_guard lock(mutex);
            if (isNewest()) progress.statistics = picture.emptyStatistics();
        }
        ProgressiveJob(order.job, picture, order.finestBlock).run(pool, *this);
    } catch (const std::bad_alloc&) {
        // No memory for this picture: the one before stays, and the job counts as over.
    }
}

std::stop_token ProgressiveRenderer::Implementation::passBegins(std::size_t pass) {
    const std::lock_guard lock(mutex);
    firstPass = pass == 0;
    if (replaced && !firstPass) stop.request_stop();
    return stop.get_token();
}

bool ProgressiveRenderer::Implementation::letGo(std::size_t pass) {
    if (abandoned) return true;
    if (!replaced) return false;
    const Clock::duration since = Clock::now().time_since_epoch() - Clock::duration(replacedAt);
    return pass > 0 || since > firstPassPatience;
}

void ProgressiveRenderer::Implementation::tileDone(FinishedTile tile, const Picture& picture,
                                                   const TileWork& work) {
    const std::lock_guard lock(mutex);
    if (isNewest()) picture.collect(work, progress.statistics);
    tiles.push_back(std::move(tile));
}

void ProgressiveRenderer::Implementation::passDone() {
    const std::lock_guard lock(mutex);
    if (isNewest()) ++progress.pass;
    // Now that the whole area is covered, nobody wants the tiles of earlier jobs any more.
    std::erase_if(tiles, [this](const FinishedTile& tile) { return tile.job < running; });
}

ProgressiveRenderer::ProgressiveRenderer(int threads)
    : implementation_(std::make_unique<Implementation>(threads)) {}

ProgressiveRenderer::~ProgressiveRenderer() = default;

std::uint64_t ProgressiveRenderer::request(RenderRequest request, int finestBlock) {
    return implementation_->request(std::move(request), finestBlock);
}

void ProgressiveRenderer::stop() { implementation_->abandon(); }

std::vector<FinishedTile> ProgressiveRenderer::takeTiles() {
    const std::lock_guard lock(implementation_->mutex);
    return std::exchange(implementation_->tiles, {});
}

RenderProgress ProgressiveRenderer::progress() const {
    const std::lock_guard lock(implementation_->mutex);
    RenderProgress progress = implementation_->progress;
    if (!progress.finished && implementation_->isNewest())
        progress.seconds = secondsSince(implementation_->start);
    return progress;
}

}  // namespace isoscope
