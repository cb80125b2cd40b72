// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <thread>

namespace isoscope::cli {

/// A stop that comes `seconds` of wall time after its making; never for an infinite number. It ends with the
/// object.
class TimeLimit {
  public:
    explicit TimeLimit(double seconds);

    /// For the work.
    std::stop_token token() const { return source_.get_token(); }
    bool over() const { return source_.stop_requested(); }

  private:
    std::stop_source source_;
    std::mutex mutex_;
    std::condition_variable_any wake_;
    std::jthread timer_;  // last: ends first
};

}  // namespace isoscope::cli
