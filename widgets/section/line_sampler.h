// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <stop_token>
#include <vector>

#include "core/shapes/isosurface/isosurface.h"

namespace isoscope {

/// A straight way through the container of an isosurface, in the coordinates of its function.
struct LineRequest {
    std::shared_ptr<const Isosurface> surface;
    std::shared_ptr<const std::vector<double>> parameterTable;
    glm::dvec3 from{0}, to{0};
    int samples = 1024;  ///< at least 2
};

/// f - threshold, |grad f| and surfaceDistance() at evenly spread places, both ends included.
struct LineSamples {
    glm::dvec3 from{0}, to{0};
    std::vector<double> values;  ///< NaN where f is undefined
    std::vector<double> slopes;  ///< NaN where f is undefined, infinite where it is infinitely steep
    std::vector<double> distances;
    double maxGradient = 1;  ///< the setting in force

    /// Whether nothing was sampled.
    bool empty() const { return values.empty(); }
    /// The distance of the ends, in the coordinates of the function.
    double length() const;
    /// The place at this share of the way: 0 is `from`, 1 is `to`.
    glm::dvec3 at(double share) const { return from + share * (to - from); }
    /// Shares of the way at which the value passes zero between two samples, at most `most`.
    std::vector<double> crossings(std::size_t most) const;
};

/// Empty without a surface, for ends that are not finite or the same, and when stopped.
LineSamples sampleLine(const LineRequest& request, std::stop_token stop = {});

}  // namespace isoscope
