// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>

namespace isoscope {

/// One background thread that only cares about the latest order: what is submitted while it works replaces
/// what was waiting, so that nothing queues up behind a fast drag. The running task is left to finish, hence
/// something is always shown; only the destructor asks it to stop, and then waits for it.
class LatestWorker {
  public:
    /// A task should look at the token often. It runs in the worker's thread, and throws nothing but
    /// std::bad_alloc, which ends it.
    using Task = std::function<void(std::stop_token)>;

    LatestWorker();
    ~LatestWorker();

    /// Hands a task over and returns at once; a task that still waits is dropped without being run. From any
    /// thread.
    void submit(Task task);
    /// Nothing runs and nothing waits.
    bool idle() const;

  private:
    void run(std::stop_token stop);

    mutable std::mutex mutex_;
    std::condition_variable_any wake_;
    Task waiting_;
    bool busy_ = false;
    std::jthread thread_;  // last: it uses the others
};

}  // namespace isoscope
