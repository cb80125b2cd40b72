// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <stop_token>
#include <vector>

#include "core/render/render_request.h"

namespace isoscope {

/// What the rays through the middles of some rows of pixels meet first, row by row from the top. Entry i of
/// each belongs to the same pixel.
struct SurfaceLayers {
    /// From the camera along the ray, in units of the scene; infinite where nothing is met.
    std::vector<float> distance;
    /// Out of the solid, unit length; 0 where nothing is met.
    std::vector<std::array<float, 3>> normal;
    /// What is certain about it; empty with POV-Ray's root finder, which proves nothing.
    std::vector<Verdict> verdict;
};

/// For rows [firstRow, firstRow + rows) of the picture, which is drawn by the same rays; POV-Ray's memory of
/// missed rays acts as in the picture where firstRow is a multiple of 32. Stopped early, the rest shows
/// nothing. `threads` 0 means all.
SurfaceLayers surfaceLayers(const RenderRequest& request, int firstRow, int rows, int threads = 0,
                            std::stop_token stop = {});

}  // namespace isoscope
