// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/progress_line.h"

#include <iostream>
#include <unistd.h>

#include "core/text/number_format.h"

namespace isoscope::cli {

namespace {

constexpr std::chrono::milliseconds firstPause(500), pause(100);

}  // namespace

ProgressLine::ProgressLine(std::string what)
    : what_(std::move(what)),
      isTerminal_(isatty(STDERR_FILENO) != 0),
      next_(std::chrono::steady_clock::now() + firstPause) {}

ProgressLine::~ProgressLine() {
    if (shown_) std::cerr << "\r\033[K" << std::flush;
}

void ProgressLine::show(double done) {
    if (!isTerminal_ || std::chrono::steady_clock::now() < next_) return;
    next_ = std::chrono::steady_clock::now() + pause;
    shown_ = true;
    std::cerr << '\r' << what_ << ": " << fixedNumber(100 * done, 0) << " %\033[K" << std::flush;
}

}  // namespace isoscope::cli
