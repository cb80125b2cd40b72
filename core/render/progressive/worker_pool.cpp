// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/progressive/worker_pool.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <thread>

namespace isoscope {

namespace {

int wantedThreads(int threads) {
    constexpr int most = 256;
    if (threads <= 0) threads = static_cast<int>(std::thread::hardware_concurrency());
    return std::clamp(threads, 1, most);
}

}  // namespace

struct WorkerPool::Implementation {
    explicit Implementation(int threads)
        : allowance(
              tbb::global_control::max_allowed_parallelism,
              std::max(static_cast<std::size_t>(threads),
                       tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism))),
          arena(threads) {}

    // Without it oneTBB gives no more threads than there are cores, and a test with more would test nothing.
    tbb::global_control allowance;
    tbb::task_arena arena;
};

WorkerPool::WorkerPool(int threads) : threads_(wantedThreads(threads)) {
    // To wake oneTBB takes longer than many a small picture.
    if (threads_ > 1) implementation_ = std::make_unique<Implementation>(threads_);
}

WorkerPool::~WorkerPool() = default;

void WorkerPool::run(std::size_t count, const std::function<void(std::size_t)>& body) {
    // A shared counter keeps the order of the tiles; oneTBB's own splitting would start in the middle.
    std::atomic<std::size_t> next{0};
    const auto work = [&](int) {
        for (std::size_t i = next++; i < count; i = next++) body(i);
    };
    if (!implementation_) return work(0);
    implementation_->arena.execute([&] { tbb::parallel_for(0, threads_, work, tbb::simple_partitioner()); });
}

}  // namespace isoscope
