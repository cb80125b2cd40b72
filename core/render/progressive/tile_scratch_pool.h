// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "core/render/picture.h"

namespace isoscope {

/// The TileWork of one picture, handed from tile to tile: memory and evaluators made anew for each of them
/// would cost more than many a tile. All methods may be called from any thread.
class TileWorkPool {
  public:
    /// A TileWork on loan; it goes back at the end of its life.
    class Loan {
      public:
        Loan(TileWorkPool& pool, std::unique_ptr<TileWork> work) : pool_(pool), work_(std::move(work)) {}
        ~Loan() { pool_.giveBack(std::move(work_)); }
        Loan(const Loan&) = delete;
        Loan& operator=(const Loan&) = delete;

        TileWork& operator*() const { return *work_; }
        TileWork* operator->() const { return work_.get(); }

      private:
        TileWorkPool& pool_;
        std::unique_ptr<TileWork> work_;
    };

    /// `picture` must outlive the pool, and the pool its loans.
    explicit TileWorkPool(const Picture& picture) : picture_(picture) {}

    /// One that has begun (Picture::begin).
    Loan take(RayOrder order, std::stop_token stop);

  private:
    std::unique_ptr<TileWork> idle();
    void giveBack(std::unique_ptr<TileWork> work);

    const Picture& picture_;
    std::mutex mutex_;
    std::vector<std::unique_ptr<TileWork>> idle_;
};

}  // namespace isoscope
