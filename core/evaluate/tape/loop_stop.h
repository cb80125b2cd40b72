// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stop_token>

namespace isoscope {

/// While it lives, `sum` and `prod` of functions evaluated by this thread end early once `stop` is requested,
/// and trees of boxes are no longer refined. The values are wrong then: whoever asks for a stop must throw
/// them away. One batch of points may go through a million steps of a loop, far too long to wait for. A
/// property of the thread because evaluators are called through layers that have no say in it, and a thread
/// works for one job at a time. Scopes may be nested; the innermost counts. Only stack objects.
class LoopStop {
  public:
    explicit LoopStop(std::stop_token stop);
    ~LoopStop();
    LoopStop(const LoopStop&) = delete;
    LoopStop& operator=(const LoopStop&) = delete;

    /// Whether the loops of this thread are to end now.
    static bool requested();
    /// What ends the loops of this thread, for another thread that works for it; none if nothing does.
    static std::stop_token current();

  private:
    std::stop_token stop_;
    const LoopStop* outer_;
};

}  // namespace isoscope
