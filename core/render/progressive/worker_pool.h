// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace isoscope {

/// A number of threads that share out numbered pieces of work. oneTBB stands behind it and nowhere else, so
/// that no header of it meets Qt's macros and another pool can take its place.
class WorkerPool {
  public:
    /// `threads` counts the calling thread; 0 means all cores.
    explicit WorkerPool(int threads = 0);
    ~WorkerPool();

    /// Threads that work in run(), the calling one included: at least 1, at most 256.
    int threads() const { return threads_; }
    /// Calls body(0) ... body(count - 1), started in this order, and returns when all are done. One call at a
    /// time.
    void run(std::size_t count, const std::function<void(std::size_t)>& body);

  private:
    struct Implementation;
    int threads_;
    std::unique_ptr<Implementation> implementation_;  ///< none for one thread
};

}  // namespace isoscope
