// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <stop_token>

#include "core/render/image.h"
#include "core/render/render_request.h"
#include "core/render/render_statistics.h"

namespace isoscope {

/// Draws the whole picture in full resolution and waits for it. `threads` 0 means all. Stopped early, the
/// rest of the picture is black. The same bytes for any number of threads. An empty image for a request that
/// cannot be drawn (no scene, no pixels, more than pixelLimit, or than there is memory).
Image renderImage(const RenderRequest& request, int threads = 0, RenderStatistics* statistics = nullptr,
                  std::stop_token stop = {});

/// Draws a picture of any height in strips of rows, from the top, so that it need not fit into memory; the
/// same pixels as renderImage() for any number of threads.
class StripRenderer {
  public:
    /// Sides of a picture that is drawn in strips.
    static constexpr int longestSide = 1 << 17;
    /// Told which share of the picture is drawn, from 0 to 1 and never backwards; from any thread, one call
    /// at a time.
    using Report = std::function<void(double share)>;

    /// `threads` 0 means all.
    explicit StripRenderer(const RenderRequest& request, int threads = 0);
    ~StripRenderer();

    /// Whether the request has a scene and a size within longestSide.
    static bool drawable(const RenderRequest& request);
    /// Rows of all strips but the last, which may have fewer.
    int stripRows() const;
    /// Draws the next strip; an empty image after the last, where the request is not drawable, and where
    /// memory is refused. Stopped early, the rest of it is black.
    Image next(std::stop_token stop = {}, const Report& report = {});
    /// The first row of the strip that is next.
    int nextRow() const;
    /// Of all strips so far.
    const RenderStatistics& statistics() const;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace isoscope
