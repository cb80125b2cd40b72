// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/shapes/rays/ray.h"

namespace isoscope {

/// The shadow rays of a batch. Kept from batch to batch for its memory.
struct ShadowRays {
    std::vector<std::uint32_t> points;  ///< of SurfacePoints, whose light the ray asks about
    std::vector<Ray> rays;
    std::vector<double> limits;  ///< what lies beyond casts no shadow
    std::vector<std::uint8_t> blocked;

    /// Empties the lists and keeps their memory.
    void clear() {
        points.clear();
        rays.clear();
        limits.clear();
        blocked.clear();
    }
};

}  // namespace isoscope
