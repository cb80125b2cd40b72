// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <stop_token>

namespace isoscope {

class ReadingWatch;

/// Watches how long a text is being read and how much memory the program takes meanwhile, on a thread that
/// all texts share: whatever reads, traces or evaluates looks at one token and ends within milliseconds. Safe
/// to be asked from any thread.
class ReadingLimits {
  public:
    /// What asked the reading to end.
    enum class Reason { nobody, caller, time, memory };

    /// Starts the watch. `outer` is the caller's own wish to stop; `seconds` of the clock and `bytes` that
    /// the program may grow by are what the text may take. Infinite seconds are no limit.
    ReadingLimits(std::stop_token outer, double seconds, std::size_t bytes);
    ~ReadingLimits();
    ReadingLimits(const ReadingLimits&) = delete;
    ReadingLimits& operator=(const ReadingLimits&) = delete;

    /// Requested as soon as anything asks to end.
    std::stop_token token() const { return source_.get_token(); }
    Reason reason() const;

  private:
    friend class ReadingWatch;

    struct Forward {
        std::stop_source source;
        void operator()() { source.request_stop(); }
    };

    std::stop_token outer_;
    std::stop_source source_;
    std::optional<std::stop_callback<Forward>> forward_;
    // The watch's, under its lock.
    std::chrono::steady_clock::time_point end_;
    std::size_t bytes_;
    std::optional<std::size_t> before_;  ///< memory at the first look
    Reason reason_ = Reason::nobody;
};

}  // namespace isoscope
