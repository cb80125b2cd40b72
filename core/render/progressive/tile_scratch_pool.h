// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "core/render/picture.h"

namespace isoscope {

/// The TileScratch of one picture, handed from tile to tile: memory and evaluators made anew for each of them
/// would cost more than many a tile. All methods may be called from any thread.
class TileScratchPool {
  public:
    /// A TileScratch on loan; it goes back at the end of its life.
    class Loan {
      public:
        Loan(TileScratchPool& pool, std::unique_ptr<TileScratch> work)
            : pool_(pool), work_(std::move(work)) {}
        ~Loan() { pool_.giveBack(std::move(work_)); }
        Loan(const Loan&) = delete;
        Loan& operator=(const Loan&) = delete;

        TileScratch& operator*() const { return *work_; }
        TileScratch* operator->() const { return work_.get(); }

      private:
        TileScratchPool& pool_;
        std::unique_ptr<TileScratch> work_;
    };

    /// `picture` must outlive the pool, and the pool its loans.
    explicit TileScratchPool(const Picture& picture) : picture_(picture) {}

    /// One that has begun (Picture::begin).
    Loan take(RayOrder order, std::stop_token stop);

  private:
    std::unique_ptr<TileScratch> idle();
    void giveBack(std::unique_ptr<TileScratch> work) noexcept;

    const Picture& picture_;
    std::mutex mutex_;
    std::vector<std::unique_ptr<TileScratch>> idle_;
};

}  // namespace isoscope
