// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/time_limit.h"

#include <algorithm>
#include <iostream>
#include <limits>

#include "app/cli/command_line.h"
#include "core/text/number_format.h"

namespace isoscope::cli {

namespace {

/// What a clock can count to without an overflow: a hundred years.
constexpr double longest = 100 * 365 * 86400.0;

}  // namespace

TimeLimit::TimeLimit(double seconds) {
    if (!(seconds < longest)) return;
    duration_ = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
    end_ = Clock::now() + duration_;
    timer_ = std::jthread([this](std::stop_token end) { wait(std::move(end)); });
}

void TimeLimit::restart() {
    if (!timer_.joinable()) return;
    const std::lock_guard lock(mutex_);
    end_ = Clock::now() + duration_;
    if (!source_.stop_requested()) return;  // the timer finds the new end at the old one
    source_ = std::stop_source();
    wake_.notify_one();
}

double TimeLimit::secondsLeft() {
    if (!timer_.joinable()) return std::numeric_limits<double>::infinity();
    const std::lock_guard lock(mutex_);
    if (source_.stop_requested()) return 0;
    return std::max(0.0, std::chrono::duration<double>(end_ - Clock::now()).count());
}

void TimeLimit::wait(std::stop_token end) {
    std::unique_lock lock(mutex_);
    while (!end.stop_requested()) {
        const Clock::time_point until = end_;
        wake_.wait_until(lock, end, until, [&] { return end_ != until; });
        if (end.stop_requested()) return;
        if (Clock::now() < end_) continue;
        source_.request_stop();
        wake_.wait(lock, end, [&] { return !source_.stop_requested(); });
    }
}

void WorkLimit::addTo(Command& command, const std::string& what) {
    command.option("--work-limit", seconds, what).positive().showDefault();
}

void WorkLimit::tell(const std::string& place, std::string_view severity, std::string_view what) const {
    std::cerr << place << ": " << severity << ": the time is over (--work-limit " << shortestNumber(seconds)
              << "); " << what << '\n';
}

}  // namespace isoscope::cli
