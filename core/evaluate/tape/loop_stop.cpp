// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/tape/loop_stop.h"

#include <utility>

namespace isoscope {

namespace {

thread_local const LoopStop* innermost = nullptr;

}  // namespace

LoopStop::LoopStop(std::stop_token stop) : stop_(std::move(stop)), outer_(std::exchange(innermost, this)) {}

LoopStop::~LoopStop() { innermost = outer_; }

bool LoopStop::requested() { return innermost && innermost->stop_.stop_requested(); }

std::stop_token LoopStop::current() { return innermost ? innermost->stop_ : std::stop_token(); }

}  // namespace isoscope
