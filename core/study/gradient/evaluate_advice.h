// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/render/render_request.h"
#include "core/study/view/traced_view.h"

namespace isoscope {

/// What one way to bound the gradient costs and gets wrong in a picture by POV-Ray's method.
struct BoundTrial {
    std::optional<std::array<double, 3>> evaluate;  ///< P0, P1, P2; nothing: a fixed max_gradient
    double maxGradient = 0;                         ///< in force at first
    double evaluationsPerPixel = 0;
    std::uint64_t mistakes = 0;  ///< pixels lost, gained or at a wrong place
};

/// Whether `evaluate` pays for an isosurface, and with which numbers.
struct EvaluateAdvice {
    BoundTrial fixed;                ///< max_gradient as it is proven to be enough; 0 where none is
    std::vector<BoundTrial> trials;  ///< with `evaluate`, in the order they were tried
    std::uint64_t pixels = 0;        ///< of the picture
    bool complete = false;           ///< false after a stop, and where there is nothing to measure

    /// The cheapest trial with no more mistakes than the fixed bound, if it is cheaper than that; null where
    /// `evaluate` does not pay.
    const BoundTrial* best() const;
};

/// Measures it for isosurface number `isosurface` in a small picture of the view: P0 from the distribution of
/// gradients in the container (0.5, 0.9, 0.99 and 0.999 of it are no steeper) and from the steepest that rays
/// meet, P1 and P2 from a few that are usual. What is told holds for this view.
EvaluateAdvice adviseEvaluate(RenderRequest view, std::size_t isosurface, int threads = 0,
                              std::stop_token stop = {}, const ShareReport& report = {});

}  // namespace isoscope
