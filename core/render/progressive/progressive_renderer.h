// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "core/render/render_request.h"
#include "core/render/render_statistics.h"

namespace isoscope {

/// A finished rectangle of the picture: width * height encoded pixels (0xffRRGGBB), row by row.
struct FinishedTile {
    std::uint64_t job = 0;
    int x = 0, y = 0, width = 0, height = 0;
    std::vector<std::uint32_t> pixels;
    int block = 1;  ///< squares of this side, from the tile's corner on, are of one colour
};

/// How far the newest job is.
struct RenderProgress {
    std::uint64_t job = 0;  ///< 0 before the first request
    int pass = 0;           ///< passes finished
    int passCount = 0;
    bool finished = true;  ///< nothing is running or waiting
    double seconds = 0;    ///< wall clock since the job began
    RenderStatistics statistics;
};

/// Draws pictures coarse to fine (blocks of 8, 2 or 4, 1 pixels) on all cores (but one, where there are more
/// than two) and keeps none itself: finished tiles are handed over by value, to be drained by the one thread
/// that paints. The tiles of each pass cover the picture once. A new request replaces the waiting one and
/// stops the running job within 10 ms, but not before its first pass is done, so that a fast drag never shows
/// nothing (only a first pass that takes longer than 1.5 s after that is given up). A request that cannot be
/// drawn (no scene, no pixels, more than pixelLimit) is over at once, without a tile. All methods may be
/// called from any thread and never block on rendering.
class ProgressiveRenderer {
  public:
    /// `threads` 0: as many as suit the machine. `news` is called, by a thread of the renderer, when a job's
    /// first pass is done and when no job is left; it must not wait for anything.
    explicit ProgressiveRenderer(int threads = 0, std::function<void()> news = {});
    /// Stops everything and joins.
    ~ProgressiveRenderer();

    /// Starts a picture as soon as the running job lets go; returns its number (1, 2, ...).
    /// `finestBlock` 1 is full resolution; 2 or 4 stop earlier, for orbiting. No coarser blocks come before
    /// a picture at full resolution that should take less than `atOnceSeconds`, going by the last complete
    /// one: they would only delay it. Should it take four times as long after all, it begins anew with them.
    std::uint64_t request(RenderRequest request, int finestBlock = 1, double atOnceSeconds = 0);
    /// Stops the running job at once, first pass or not, and forgets the waiting one.
    void stop();

    /// Tiles finished since the last call, oldest first. Those of a replaced job are still among them until
    /// the first pass of its successor is done, then they are left out. Once progress() says finished, all
    /// tiles are there.
    std::vector<FinishedTile> takeTiles();
    RenderProgress progress() const;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace isoscope
