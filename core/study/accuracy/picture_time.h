// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <stop_token>

#include "core/render/render_request.h"

namespace isoscope {

/// How long a picture will take here, from squares of it that were drawn.
struct PictureTime {
    double cpuSeconds = 0;    ///< of all threads, for drawing: what RenderStatistics::cpuSeconds will be
    double error = 0;         ///< share of it that it may be off by, nineteen times in twenty
    std::size_t sampled = 0;  ///< squares that were drawn
    std::size_t squares = 0;  ///< of the whole picture
    bool complete = false;    ///< no further squares are to be drawn

    /// Seconds until the picture is drawn by so many threads (at least 1) that have a core each.
    double secondsWith(int threads) const { return cpuSeconds / threads; }
};

/// When to be content.
struct PictureTimeEffort {
    double error = 0.105;  ///< of the prediction, which never is below timingError
    double seconds = 1;    ///< of processor time, after which `lateError` is enough
    double lateError = 0.15;
    std::size_t squares = 24;  ///< drawn at least, while no more than `mostSeconds` have passed
    double mostSeconds = 5;    ///< of processor time, whatever is known by then
};

/// What timing itself is off by on a machine that does other things as well: less is never told.
constexpr double timingError = 0.1;

/// Draws squares of the picture, at its full size and with its smooth edges, spread evenly over it, and takes
/// the rest to be like them. `report` is told from this thread what is known after the first eight squares,
/// and then after every half as many more. In the calling thread alone. Nothing (no squares) for a request
/// that cannot be drawn, or that is stopped before the first square is.
PictureTime predictPictureTime(const RenderRequest& request, const PictureTimeEffort& effort = {},
                               std::stop_token stop = {},
                               const std::function<void(const PictureTime&)>& report = {});

}  // namespace isoscope
