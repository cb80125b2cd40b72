// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/shapes/shape.h"

namespace isoscope {

/// The rays of a batch that one object is asked about, so that it sees a dense list. Kept from batch to batch
/// for its memory.
struct GatheredRays {
    std::vector<std::uint32_t> indices;  ///< in the batch
    std::vector<Ray> rays;
    std::vector<NearestHit> nearest;

    void clear() {
        indices.clear();
        rays.clear();
        nearest.clear();
    }
    void add(std::size_t index, const Ray& ray, const NearestHit& bound) {
        indices.push_back(static_cast<std::uint32_t>(index));
        rays.push_back(ray);
        nearest.push_back(bound);
    }
};

}  // namespace isoscope
