// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
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

/// Draws pictures coarse to fine (blocks of 8, 2, 1 pixels) on all cores but keeps none itself: finished
/// tiles are handed over by value, to be drained by the one thread that paints. A new request replaces the
/// waiting one and stops the running job within 10 ms, but not before its first pass is done, so that a fast
/// drag never shows nothing. All methods may be called from any thread and never block on rendering.
class ProgressiveRenderer {
  public:
    explicit ProgressiveRenderer(int threads = 0);
    /// Stops everything and joins.
    ~ProgressiveRenderer();

    /// Starts a picture as soon as the running job lets go; returns its number (1, 2, ...).
    /// `finestBlock` 1 is full resolution; 2 or 4 stop earlier, for orbiting.
    std::uint64_t request(RenderRequest request, int finestBlock = 1);
    void stop();

    /// Tiles finished since the last call, oldest first; those of replaced jobs are left out.
    std::vector<FinishedTile> takeTiles();
    RenderProgress progress() const;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace isoscope
