// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

}  // namespace isoscope
