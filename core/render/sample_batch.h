// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

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
    std::vector<glm::dvec3> arriving;  ///< what the light at hand adds to each sample

    std::size_t size() const { return places.size(); }
    /// Empties all lists but `places` and gives them its length.
    void begin() {
        rays.assign(size(), Ray());
        nearest.assign(size(), NearestHit());
        colors.assign(size(), glm::dvec3(0));
        arriving.assign(size(), glm::dvec3(0));
    }
};

}  // namespace isoscope
