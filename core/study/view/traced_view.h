// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <stop_token>
#include <vector>

#include "core/render/render_request.h"
#include "core/shapes/hit.h"

namespace isoscope {

/// What the ray through the middle of one pixel meets first.
struct TracedPixel {
    bool found = false;
    HitKind kind = HitKind::crossing;
    double t = 0;  ///< in units of length: camera rays have unit directions
};

/// A picture reduced to what its rays meet, for comparing root finders.
struct TracedView {
    int width = 0;
    int height = 0;
    std::vector<TracedPixel> pixels;  ///< row by row from the top
    std::uint64_t evaluations = 0;
    double cpuSeconds = 0;           ///< of all threads, tracing alone
    double steepest = 0;             ///< slope met by the Lipschitz root finder
    std::vector<double> steepestOf;  ///< the same for each isosurface of the scene
    bool complete = false;           ///< false when stopped, or when the request cannot be drawn
};

/// Told how far a study is, from 0 to 1 and never backwards; from any thread, one call at a time.
using ShareReport = std::function<void(double share)>;

/// Traces the rays of a picture, tile by tile as the renderer does, so that POV-Ray's memory of missed rays
/// acts in the same way. `threads` 0 means all cores. Tiles smaller than the renderer's report more often,
/// but forget missed rays sooner.
constexpr int rendererTile = 32;
TracedView traceView(const RenderRequest& request, int threads = 0, std::stop_token stop = {},
                     const ShareReport& report = {}, int tileSize = rendererTile);

/// The camera's ray through the middle of a pixel.
Ray pixelRay(const RenderRequest& request, int x, int y);

}  // namespace isoscope
