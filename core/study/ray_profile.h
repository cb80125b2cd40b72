// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/roots/line_query.h"
#include "core/scene/scene.h"

namespace isoscope {

/// A place on a ray with g there: f - threshold, negative inside (the other way round with positive
/// polarity).
struct ProfilePoint {
    double t = 0;
    double value = 0;
};

/// What an isosurface is along one ray: the picture that explains a hole.
struct RayProfile {
    bool meetsContainer = false;
    double near =
        0;  ///< where the container begins and ends; t counts lengths in the world, as along a camera ray
    double far = 0;
    std::vector<ProfilePoint> curve;    ///< evenly spread from near to far
    std::vector<ProfilePoint> visited;  ///< what POV-Ray's method evaluates, in its order
    RootList povrayRoots;               ///< what that finds with the present settings
    RootList certifiedRoots;            ///< what is there
    double maxGradient = 0;             ///< slope of the cones: per unit of t
};

/// `ray` in world coordinates with a direction of length 1; `curvePoints` at least 2.
RayProfile profileOf(const Scene& scene, std::size_t isosurface, const Ray& ray, int curvePoints = 512);

}  // namespace isoscope
