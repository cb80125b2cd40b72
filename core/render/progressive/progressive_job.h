// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/render/picture.h"
#include "core/render/progressive/block_passes.h"
#include "core/render/progressive/progressive_renderer.h"
#include "core/render/progressive/tile_scratch_pool.h"
#include "core/render/progressive/worker_pool.h"

namespace isoscope {

/// One picture, drawn coarse to fine.
class ProgressiveJob {
  public:
    /// What a job tells and asks while it runs: letGo() and tileDone() from all threads of the pool, the
    /// others from the thread that called run().
    class Listener {
      public:
        virtual ~Listener() = default;
        /// A pass begins (they count from 0); what is returned ends it at once, in the middle of a ray.
        virtual std::stop_token passBegins(std::size_t pass) = 0;
        /// Asked before every batch of rays: whether to stop there.
        virtual bool letGo(std::size_t pass) = 0;
        /// A tile of the pass is drawn; `work` is valid during the call only.
        virtual void tileDone(FinishedTile tile, const Picture& picture, const TileScratch& work) = 0;
        /// All tiles of the pass are drawn.
        virtual void passDone() = 0;
    };

    /// `picture` must outlive the job.
    ProgressiveJob(std::uint64_t number, const Picture& picture, int finestBlock, bool onePass = false);

    /// The passes that run() draws.
    const BlockPasses& passes() const { return passes_; }

    /// Draws all passes, or as many as the listener lets it; whether those were all.
    bool run(WorkerPool& pool, Listener& listener);

  private:
    bool runPass(std::size_t pass, WorkerPool& pool, Listener& listener);
    bool drawTile(std::size_t pass, const PixelRectangle& area, std::stop_token stop, Listener& listener);
    bool drawWhole(const PixelRectangle& area, TileScratch& work, Listener& listener, FinishedTile& tile);
    bool drawMissing(std::size_t pass, const PixelRectangle& area, TileScratch& work, Listener& listener,
                     FinishedTile& tile);
    void findMissing(std::size_t pass, const PixelRectangle& area, std::vector<PixelIndex>& pixels) const;
    void fillBlocks(std::size_t pass, FinishedTile& tile) const;
    bool onePass() const { return passes_.count() == 1 && isFullResolution(0); }
    bool isFullResolution(std::size_t pass) const { return passes_.block(pass) == 1; }
    /// Whether the pass draws all its pixels, drawn before or not: anti-aliasing is for the pass at full
    /// resolution, and so is POV-Ray's order of rays.
    bool drawsAnew(std::size_t pass) const;
    std::uint32_t& pixel(int x, int y);

    std::uint64_t number_;
    const Picture& picture_;
    TileScratchPool works_;
    BlockPasses passes_;
    /// Drawn so far, unless there is but one pass; threads touch their own tiles only.
    std::vector<std::uint32_t> pixels_;
};

}  // namespace isoscope
