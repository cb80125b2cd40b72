// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <string>

namespace isoscope::cli {

/// How far long work is: one line on standard error that is written over, if that is a terminal and the work
/// takes more than half a second. Ctrl+C stops the program, as always.
class ProgressLine {
  public:
    /// `what` stands before the share.
    explicit ProgressLine(std::string what);
    /// Leaves an empty line.
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    /// From 0 to 1; may be called very often.
    void show(double done);

  private:
    std::string what_;
    bool isTerminal_;
    bool shown_ = false;
    std::chrono::steady_clock::time_point next_;
};

}  // namespace isoscope::cli
