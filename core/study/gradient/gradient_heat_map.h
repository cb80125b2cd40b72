// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <stop_token>
#include <vector>

#include "core/study/view/traced_view.h"

namespace isoscope {

/// |grad f| at the visible points of the isosurfaces, as a share of the max_gradient in force there.
struct GradientHeatMap {
    int width = 0;
    int height = 0;
    std::vector<float> shares;  ///< row by row from the top; NaN where no isosurface is seen
    double largest = 0;         ///< share; may be infinite
    std::uint64_t seen = 0;     ///< pixels that show an isosurface
    std::uint64_t over = 0;     ///< those steeper than max_gradient
    bool complete = false;
};

/// Traces the request with the certified root finder, whatever its own is.
GradientHeatMap gradientHeatMap(RenderRequest request, int threads = 0, std::stop_token stop = {},
                                const ShareReport& report = {});

/// |grad f| in the pixels of `truth`, the traced `request`, in which isosurface number `isosurface` is seen;
/// NaN elsewhere. `tolerance` is how far a hit may lie from the surface.
std::vector<double> slopesOnSurface(const RenderRequest& request, const TracedView& truth,
                                    std::size_t isosurface, double tolerance);

}  // namespace isoscope
