// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/reading_limits.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <condition_variable>
#include <cstring>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#if defined(__linux__)
#include <fcntl.h>
#include <unistd.h>
#endif

namespace isoscope {

namespace {

using Clock = std::chrono::steady_clock;

/// How often the memory is looked at.
constexpr std::chrono::milliseconds interval{20};
/// For how many looks the thread goes on when nothing is read: to wake it costs more than to read a short
/// text.
constexpr int idleLooks = 50;

/// Bytes that the program has in memory; 0 where the system does not tell. Asks for no memory itself.
std::size_t residentMemory() {
#if defined(__linux__)
    const int file = open("/proc/self/statm", O_RDONLY | O_CLOEXEC);
    if (file < 0) return 0;
    std::array<char, 64> text{};
    const ssize_t size = read(file, text.data(), text.size() - 1);
    close(file);
    // All pages, a blank, those in memory.
    const char* const blank = size > 0 ? std::strchr(text.data(), ' ') : nullptr;
    std::size_t resident = 0;
    if (blank && std::from_chars(blank + 1, text.data() + text.size(), resident).ec == std::errc())
        return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
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

/// The thread that looks at all texts that are being read. To start one of its own for each would take twice
/// as long as to read a short text.
class ReadingWatch {
  public:
    static ReadingWatch& ofAllTexts() {
        static ReadingWatch watch;
        return watch;
    }

    void add(ReadingLimits& limits) {
        const std::lock_guard lock(mutex_);
        watched_.push_back(&limits);
        if (!sleeping_ && limits.end_ >= next_) return;
        next_ = std::min(next_, limits.end_);
        changed_.notify_one();
    }

    void remove(ReadingLimits& limits) {
        const std::lock_guard lock(mutex_);
        std::erase(watched_, &limits);
    }

    ReadingLimits::Reason reasonOf(const ReadingLimits& limits) {
        const std::lock_guard lock(mutex_);
        return limits.reason_;
    }

  private:
    ReadingWatch() : thread_([this](const std::stop_token& end) { watch(end); }) {}

    void watch(const std::stop_token& end) {
        const std::stop_callback wake(end, [this] {
            const std::lock_guard lock(mutex_);
            changed_.notify_one();
        });
        std::unique_lock lock(mutex_);
        for (int idle = 0; !end.stop_requested();) {
            if (watched_.empty() && idle >= idleLooks) {
                sleeping_ = true;
                changed_.wait(lock, [&] { return end.stop_requested() || !watched_.empty(); });
                sleeping_ = false;
            }
            next_ = Clock::now() + interval;
            for (const ReadingLimits* limits : watched_)
                if (limits->reason_ == ReadingLimits::Reason::nobody) next_ = std::min(next_, limits->end_);
            while (!end.stop_requested() && Clock::now() < next_) changed_.wait_until(lock, next_);
            idle = watched_.empty() ? idle + 1 : 0;
            if (idle > 0) continue;
            const std::size_t memory = residentMemory();
            // Without the lock: what is told of it may itself begin or end to read.
            while (std::optional<std::stop_source> over = firstOver(memory)) {
                lock.unlock();
                over->request_stop();
                over.reset();
                lock.lock();
            }
        }
    }

    /// One whose time or memory is used up, and that was not told so.
    std::optional<std::stop_source> firstOver(std::size_t memory) {
        for (ReadingLimits* limits : watched_) {
            if (limits->reason_ != ReadingLimits::Reason::nobody) continue;
            if (!limits->before_) limits->before_ = memory;
            const std::size_t before = *limits->before_;
            if (memory > before && memory - before > limits->bytes_)
                limits->reason_ = ReadingLimits::Reason::memory;
            if (Clock::now() >= limits->end_) limits->reason_ = ReadingLimits::Reason::time;
            if (limits->reason_ != ReadingLimits::Reason::nobody) return limits->source_;
        }
        return std::nullopt;
    }

    std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<ReadingLimits*> watched_;
    Clock::time_point next_ = Clock::time_point::max();  ///< of the next look
    bool sleeping_ = false;
    std::jthread thread_;  // last: ends first
};

ReadingLimits::ReadingLimits(std::stop_token outer, double seconds, std::size_t bytes)
    : outer_(std::move(outer)), end_(endAfter(seconds)), bytes_(bytes) {
    forward_.emplace(outer_, Forward{source_});
    ReadingWatch::ofAllTexts().add(*this);
}

ReadingLimits::~ReadingLimits() { ReadingWatch::ofAllTexts().remove(*this); }

ReadingLimits::Reason ReadingLimits::reason() const {
    return outer_.stop_requested() ? Reason::caller : ReadingWatch::ofAllTexts().reasonOf(*this);
}

}  // namespace isoscope
