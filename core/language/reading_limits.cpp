// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/reading_limits.h"

#include <algorithm>
#include <fstream>
#include <utility>

#if defined(__linux__)
#include <unistd.h>
#endif

namespace isoscope {

namespace {

using Clock = std::chrono::steady_clock;

/// How often the memory is looked at.
constexpr std::chrono::milliseconds interval{20};

/// Bytes that the program has in memory; 0 where the system does not tell.
std::size_t residentMemory() {
#if defined(__linux__)
    std::ifstream pages("/proc/self/statm");
    std::size_t all = 0, resident = 0;
    if (pages >> all >> resident) return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
#endif
    return 0;
}

Clock::time_point endAfter(double seconds) {
    constexpr double longest = 1e8;
    if (!(seconds < longest)) return Clock::time_point::max();
    return Clock::now() +
           std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(std::max(seconds, 0.0)));
}

}  // namespace

ReadingLimits::ReadingLimits(std::stop_token outer, double seconds, std::size_t bytes)
    : outer_(std::move(outer)) {
    forward_.emplace(outer_, Forward{source_});
    watcher_ = std::thread([this, end = endAfter(seconds), bytes] { watch(end, bytes); });
}

ReadingLimits::~ReadingLimits() {
    {
        const std::lock_guard lock(mutex_);
        finished_ = true;
    }
    ended_.notify_all();
    watcher_.join();
}

ReadingLimits::Reason ReadingLimits::reason() const {
    if (outer_.stop_requested()) return Reason::caller;
    const std::lock_guard lock(mutex_);
    return reason_;
}

void ReadingLimits::watch(Clock::time_point end, std::size_t bytes) {
    std::unique_lock lock(mutex_);
    // Most texts are read before there is anything to look at.
    std::optional<std::size_t> before;
    while (!finished_ && reason_ == Reason::nobody) {
        ended_.wait_until(lock, std::min(end, Clock::now() + interval));
        if (finished_) return;
        const std::size_t memory = residentMemory();
        if (!before) before = memory;
        if (memory > *before && memory - *before > bytes) reason_ = Reason::memory;
        if (Clock::now() >= end) reason_ = Reason::time;
    }
    lock.unlock();
    source_.request_stop();
}

}  // namespace isoscope
