// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <stop_token>
#include <vector>

#include "core/scene/scene.h"

namespace isoscope {

/// How often which |grad f| occurs, in bins of equal width in the logarithm. What is below the first edge,
/// zeros too, is counted in the first bin.
struct GradientHistogram {
    std::vector<double> edges;      ///< one more than bins; empty when there is nothing to count
    std::vector<double> container;  ///< share of the container's volume in each bin
    std::vector<double> surface;    ///< share of the surface's area in each bin; zeros when there is none
    std::uint64_t containerSamples = 0;
    std::uint64_t surfaceSamples = 0;
    std::uint64_t infinite = 0;  ///< samples of both kinds with an infinite gradient; in no bin

    /// Whether nothing was sampled: the lists are empty.
    bool empty() const { return edges.empty(); }
};

/// Samples the container at evenly spread points, and the surface where isotropic random lines meet it (which
/// are evenly spread over its area), with a fixed seed. Empty for containers that are not finite and when
/// stopped.
GradientHistogram gradientHistogram(const Scene& scene, std::size_t isosurface, std::stop_token stop = {});

}  // namespace isoscope
