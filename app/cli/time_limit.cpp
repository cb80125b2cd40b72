// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/time_limit.h"

#include <chrono>

namespace isoscope::cli {

namespace {

/// What a clock can count to without an overflow: a hundred years.
constexpr double longest = 100 * 365 * 86400.0;

}  // namespace

TimeLimit::TimeLimit(double seconds) {
    if (!(seconds < longest)) return;
    timer_ = std::jthread([this, seconds](std::stop_token end) {
        std::unique_lock lock(mutex_);
        wake_.wait_for(lock, end, std::chrono::duration<double>(seconds), [] { return false; });
        if (!end.stop_requested()) source_.request_stop();
    });
}

}  // namespace isoscope::cli
