// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/shapes/rays/bvh.h"
#include "core/shapes/rays/ray_selection.h"

namespace isoscope {

/// The rays of a batch that one object of a scene is asked about. Kept from batch to batch for its memory.
struct GatheredRays : RaySelection {
    RayBatch all;    ///< rays that came as a list
    HitBatch known;  ///< what lies behind counts no more for them

    /// Of the many objects of a scene, those that the tree found for the batch.
    struct Candidate {
        std::uint32_t object;
        std::uint32_t first, count;  ///< its rays among `candidateRays`
    };
    BoxTreeWalk walk;
    std::vector<Candidate> candidates;
    std::vector<std::uint32_t> candidateRays;
};

}  // namespace isoscope
