// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/latest_worker.h"

#include <utility>

#include "widgets/refused_memory.h"

namespace isoscope {

LatestWorker::LatestWorker() : thread_([this](std::stop_token stop) { run(stop); }) {}

LatestWorker::~LatestWorker() = default;

void LatestWorker::submit(Task task) {
    {
        const std::lock_guard lock(mutex_);
        waiting_.swap(task);
    }
    wake_.notify_one();
}

bool LatestWorker::idle() const {
    const std::lock_guard lock(mutex_);
    return !busy_ && !waiting_;
}

void LatestWorker::run(std::stop_token stop) {
    std::unique_lock lock(mutex_);
    while (wake_.wait(lock, stop, [this] { return static_cast<bool>(waiting_); }) && !stop.stop_requested()) {
        Task task = std::exchange(waiting_, nullptr);
        busy_ = true;
        lock.unlock();
        doneUnlessMemoryIsRefused([&] { task(stop); });
        // What it holds, scenes for one, may take long to go, and the lock keeps callers waiting.
        task = nullptr;
        lock.lock();
        busy_ = false;
    }
}

}  // namespace isoscope
