// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>

namespace isoscope::cli {

class Command;

/// A stop that comes `seconds` of wall time after its making; never for an infinite number. It ends with the
/// object. For one thread, but for its token.
class TimeLimit {
  public:
    explicit TimeLimit(double seconds);

    /// The time begins anew. If it was over, token() is another one from now on.
    void restart();

    /// For the work.
    std::stop_token token() const { return source_.get_token(); }
    bool over() const { return source_.stop_requested(); }
    /// Until the stop: 0 once it has come, infinite where none will.
    double secondsLeft();

  private:
    using Clock = std::chrono::steady_clock;

    void wait(std::stop_token end);

    Clock::duration duration_{};
    std::stop_source source_;
    std::mutex mutex_;  ///< of source_ and end_
    Clock::time_point end_;
    std::condition_variable_any wake_;
    std::jthread timer_;  // last: ends first
};

/// `--work-limit`: how long a command may work on what it has read.
struct WorkLimit {
    /// Proofs and searches end with what they have found; pictures and tables are what was asked for.
    static constexpr double ofStudies = 20, ofPictures = 600;

    double seconds = ofStudies;

    /// Adds the option; `what` says what the time is for.
    void addTo(Command& command, const std::string& what = "Seconds to work on the scene");
    /// "PLACE: note: the time is over (--work-limit 20); WHAT" on standard error.
    void note(const std::string& place, std::string_view what) const { tell(place, "note", what); }
    /// The same with "error", where what was asked for is not given.
    void error(const std::string& place, std::string_view what) const { tell(place, "error", what); }

  private:
    void tell(const std::string& place, std::string_view severity, std::string_view what) const;
};

}  // namespace isoscope::cli
