// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "core/render/surface_points.h"
#include "core/roots/verdict.h"
#include "core/shapes/hit_batch.h"
#include "core/shapes/ray_batch.h"

namespace isoscope {

/// Some samples of the picture on their way through the stages. Lists keep their memory from batch to batch.
struct SampleBatch {
    /// Where the sample lies in the picture: pixels from the left and from the top, pixel centres at one
    /// half.
    struct Place {
        double x = 0, y = 0;
    };

    /// A rectangle of the picture, its sides included.
    struct Extent {
        Place low, high;

        void add(const Extent& other) {
            low = {std::min(low.x, other.low.x), std::min(low.y, other.low.y)};
            high = {std::max(high.x, other.high.x), std::max(high.y, other.high.y)};
        }
    };

    // Entry i of each belongs to sample i.
    std::vector<Place> places;
    std::vector<glm::dvec3> colors;  ///< in the colour space of the scene (GlobalSettings::assumedGamma)
    std::vector<Verdict> verdicts;   ///< what is certain about the hit or miss, with a certified root finder

    // The rays of those samples that may meet something; Ray::sample says whose they are.
    RayBatch rays;
    std::vector<Extent> extents;  ///< of samples that follow each other
    HitBatch hits;                ///< of each ray, with the material in force
    SurfacePoints points;         ///< where they have met something

    std::size_t size() const { return places.size(); }
    /// A batch for `places`: no ray is sent yet, nothing is met, and the colours mean nothing before the
    /// background is laid.
    void begin() {
        colors.resize(size());
        verdicts.assign(size(), Verdict::certifiedMiss);
        rays.clear();
        points.clear();
    }
};

}  // namespace isoscope
