// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stop_token>
#include <vector>

#include "core/roots/line_query.h"
#include "core/scene/scene.h"
#include "core/study/view/explained_search.h"
#include "core/study/view/ray_enclosures.h"

namespace isoscope {

/// What an isosurface is along one ray: the picture that explains a hole.
struct RayProfile {
    bool meetsContainer = false;
    double near =
        0;  ///< where the container begins and ends; t counts lengths in the world, as along a camera ray
    double far = 0;
    std::vector<ProfilePoint> curve;  ///< evenly spread from near to far
    ExplainedSearch povray;           ///< POV-Ray's method with the present settings, for this ray alone
    RootList certifiedRoots;          ///< what is there, walls of the container included; at most ten
    std::vector<RayEnclosure> enclosures;
    double maxGradient = 0;  ///< slope of the cones: per unit of t
    double accuracy = 0;

    /// Whether POV-Ray's method was wrong to prune an interval: a certified crossing lies in it.
    bool wronglyPruned(const SearchedInterval& interval) const;
};

/// The profile of an isosurface of the scene; empty for a ray that misses its container.
/// `ray` in world coordinates with a direction of length 1; `curvePoints` at least 2. Stopped early,
/// the profile is of no use.
RayProfile profileOf(const Scene& scene, std::size_t isosurface, const Ray& ray, int curvePoints = 512,
                     std::stop_token stop = {});

}  // namespace isoscope
