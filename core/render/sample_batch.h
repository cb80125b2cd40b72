// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "core/render/light_arrival.h"
#include "core/roots/verdict.h"
#include "core/shapes/shape.h"

namespace isoscope {

/// Some rays of the picture on their way through the stages: entry i of every list belongs to sample i. Lists
/// keep their memory from batch to batch.
struct SampleBatch {
    /// Where the sample lies in the picture: pixels from the left and from the top, pixel centres at one
    /// half.
    struct Place {
        double x = 0, y = 0;
    };

    std::vector<Place> places;
    std::vector<Ray> rays;
    std::vector<NearestHit> nearest;   ///< with the material in force
    std::vector<glm::dvec3> colors;    ///< in the colour space of the scene (GlobalSettings::assumedGamma)
    std::vector<Verdict> verdicts;     ///< what is certain about `nearest`, with a certified root finder
    std::vector<glm::dvec3> arriving;  ///< what the light at hand adds to each sample
    /// How the light at hand reaches each sample that it adds something to.
    std::vector<LightArrival> arrivals;

    std::size_t size() const { return places.size(); }
    /// Gives all lists the length of `places`: no sample has met anything and all are black. Rays and light
    /// are set by the stages that need them.
    void begin() {
        rays.resize(size());
        nearest.resize(size());
        for (NearestHit& hit : nearest) hit.found = false;
        colors.assign(size(), glm::dvec3(0));
        arriving.resize(size());
        arrivals.resize(size());
        verdicts.assign(size(), Verdict::certifiedMiss);
    }
};

}  // namespace isoscope
