// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/progressive/progressive_renderer.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <iterator>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "core/render/image.h"
#include "core/render/progressive/progressive_job.h"
#include "core/render/progressive/worker_pool.h"

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
        double atOnceSeconds = 0;
    };

    Implementation(int threads, std::function<void()> tell)
        : pool(defaultThreads(threads)),
          news(std::move(tell)),
          coordinator([this](std::stop_token end) { coordinate(end); }) {}
    ~Implementation() override { abandon(); }

    std::uint64_t request(RenderRequest request, int finestBlock, double atOnceSeconds);
    void abandon();
    void coordinate(std::stop_token end);
    void run(const Order& order);
    bool isQuick(const Order& order) const;
    void begin(const Picture& picture, const BlockPasses& passes);
    void noteSeconds(const Order& order, double seconds);
    /// In one pass. False when that takes too long: nothing of it is handed over then.
    bool drawAtOnce(const Order& order, const Picture& picture);
    void draw(const Order& order, const Picture& picture);
    bool isNewest() const { return running == progress.job; }

    std::stop_token passBegins(std::size_t pass) override;
    bool letGo(std::size_t pass) override;
    void tileDone(FinishedTile tile, const Picture& picture, const TileScratch& work) override;
    void passDone() override;

    WorkerPool pool;
    const std::function<void()> news;

    mutable std::mutex mutex;  // guards what follows, down to the flags
    std::condition_variable_any wake;
    std::optional<Order> waiting;
    std::uint64_t running = 0;  ///< number of the running job, else 0
    RenderProgress progress;    ///< of the newest job
    Clock::time_point start;    ///< of the running job
    std::vector<FinishedTile> tiles;
    std::vector<FinishedTile> held;  ///< of a pass that may be given up
    bool firstPass = true;           ///< the running job is in it
    double secondsPerPixel = 0;      ///< of the last complete picture; 0 before the first
    std::stop_source stop;           ///< of the pass at hand

    std::atomic<bool> replaced{false};   ///< let go, but not before the first pass is done
    std::atomic<bool> abandoned{false};  ///< let go at once
    std::atomic<Clock::rep> replacedAt{0};
    /// When the running job gives up to be drawn in one pass; no time for jobs that are not.
    std::optional<Clock::time_point> atOnceUntil;

    std::jthread coordinator;  // last: ends first
};

std::uint64_t ProgressiveRenderer::Implementation::request(RenderRequest request, int finestBlock,
                                                           double atOnceSeconds) {
    std::optional<Order> order;  // outlives the lock, for the scene that it may take away
    const std::lock_guard lock(mutex);
    const std::uint64_t job = progress.job + 1;
    RenderProgress begun;
    begun.job = job;
    begun.finished = false;
    if (Picture::drawable(request))
        begun.passCount = static_cast<int>(BlockPasses(request.width, request.height, finestBlock).count());
    progress = std::move(begun);
    order = Order{job, std::move(request), finestBlock, atOnceSeconds};
    waiting.swap(order);
    if (running != 0 && !replaced) {
        replacedAt = Clock::now().time_since_epoch().count();
        replaced = true;
        if (!firstPass) stop.request_stop();
    }
    wake.notify_one();
    return job;
}

void ProgressiveRenderer::Implementation::abandon() {
    std::optional<Order> forgotten;  // outlives the lock
    const std::lock_guard lock(mutex);
    forgotten.swap(waiting);
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
        std::optional<Order> order = std::exchange(waiting, std::nullopt);
        running = order->job;
        replaced = abandoned = false;
        firstPass = true;
        stop = {};
        start = Clock::now();
        lock.unlock();
        run(*order);
        // A scene may take long to go, and the lock keeps callers waiting.
        order.reset();
        lock.lock();
        if (isNewest()) {
            progress.seconds = secondsSince(start);
            progress.finished = true;
        }
        running = 0;
        // A job stopped by stop() while another waited leaves no one to say that all is over.
        if (waiting) continue;
        progress.finished = true;
        lock.unlock();
        if (news) news();
        lock.lock();
    }
}

void ProgressiveRenderer::Implementation::run(const Order& order) {
    if (!Picture::drawable(order.request)) return;
    try {
        const Picture picture(order.request);
        if (!isQuick(order) || !drawAtOnce(order, picture)) draw(order, picture);
    } catch (const std::bad_alloc&) {
        // No memory for this picture: the one before stays, and the job counts as over.
    }
}

bool ProgressiveRenderer::Implementation::isQuick(const Order& order) const {
    const std::lock_guard lock(mutex);
    const double seconds = secondsPerPixel * order.request.width * order.request.height;
    return order.finestBlock <= 1 && seconds > 0 && seconds < order.atOnceSeconds;
}

void ProgressiveRenderer::Implementation::begin(const Picture& picture, const BlockPasses& passes) {
    const std::lock_guard lock(mutex);
    if (!isNewest()) return;
    progress.statistics = picture.emptyStatistics();
    progress.passCount = static_cast<int>(passes.count());
}

void ProgressiveRenderer::Implementation::noteSeconds(const Order& order, double seconds) {
    // Smooth edges take longer; what is asked about is pictures that move, which have none.
    if (order.request.antialias) return;
    const std::lock_guard lock(mutex);
    secondsPerPixel = seconds / order.request.width / order.request.height;
}

bool ProgressiveRenderer::Implementation::drawAtOnce(const Order& order, const Picture& picture) {
    constexpr double patience = 4;
    ProgressiveJob job(order.job, picture, 1, true);
    begin(picture, job.passes());
    const std::chrono::duration<double> longest(patience * order.atOnceSeconds);
    atOnceUntil = start + std::chrono::duration_cast<Clock::duration>(longest);
    const bool complete = job.run(pool, *this);
    atOnceUntil.reset();
    if (!abandoned) noteSeconds(order, secondsSince(start));
    const std::lock_guard lock(mutex);
    held.clear();
    return complete || abandoned || replaced;
}

void ProgressiveRenderer::Implementation::draw(const Order& order, const Picture& picture) {
    // How much longer several passes take than one: their rays are no neighbours.
    constexpr double dearer = 1.5;
    ProgressiveJob job(order.job, picture, order.finestBlock);
    begin(picture, job.passes());
    if (job.run(pool, *this) && order.finestBlock <= 1) noteSeconds(order, secondsSince(start) / dearer);
}

std::stop_token ProgressiveRenderer::Implementation::passBegins(std::size_t pass) {
    const std::lock_guard lock(mutex);
    firstPass = pass == 0;
    if (replaced && !firstPass) stop.request_stop();
    return stop.get_token();
}

bool ProgressiveRenderer::Implementation::letGo(std::size_t pass) {
    if (abandoned) return true;
    if (atOnceUntil) return Clock::now() > *atOnceUntil;
    if (!replaced) return false;
    const Clock::duration since = Clock::now().time_since_epoch() - Clock::duration(replacedAt);
    return pass > 0 || since > firstPassPatience;
}

void ProgressiveRenderer::Implementation::tileDone(FinishedTile tile, const Picture& picture,
                                                   const TileScratch& work) {
    const std::lock_guard lock(mutex);
    if (isNewest()) {
        picture.collect(work, progress.statistics);
        picture.collectGradients(work, progress.statistics);
    }
    (atOnceUntil ? held : tiles).push_back(std::move(tile));
}

void ProgressiveRenderer::Implementation::passDone() {
    {
        const std::lock_guard lock(mutex);
        if (isNewest()) ++progress.pass;
        // Now that the whole area is covered, the tiles of earlier jobs are not needed any more.
        std::erase_if(tiles, [this](const FinishedTile& tile) { return tile.job < running; });
        std::move(held.begin(), held.end(), std::back_inserter(tiles));
        held.clear();
        // The end of the job is news enough.
        const bool last = isNewest() && progress.pass == progress.passCount;
        if (!firstPass || last) return;
    }
    if (news) news();
}

ProgressiveRenderer::ProgressiveRenderer(int threads, std::function<void()> news)
    : implementation_(std::make_unique<Implementation>(threads, std::move(news))) {}

ProgressiveRenderer::~ProgressiveRenderer() = default;

std::uint64_t ProgressiveRenderer::request(RenderRequest request, int finestBlock, double atOnceSeconds) {
    return implementation_->request(std::move(request), finestBlock, atOnceSeconds);
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
