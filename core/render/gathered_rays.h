// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/shapes/box_tree.h"
#include "core/shapes/hit_batch.h"
#include "core/shapes/ray_batch.h"
#include "core/shapes/slab_batch.h"

namespace isoscope {

/// The rays of a batch that one object is asked about, so that it sees a dense batch. Kept from batch to
/// batch for its memory.
struct GatheredRays {
    RayBatch rays;
    HitBatch hits;

    RayBatch all;    ///< rays that came as a list
    HitBatch known;  ///< what lies behind counts no more for them

    SlabBatch slabs;                     ///< of the whole batch
    std::vector<std::uint32_t> meeting;  ///< rays of the batch that may meet the box at hand

    /// Of the many objects of a scene, those that the tree found for the batch.
    struct Candidate {
        std::uint32_t object;
        std::uint32_t first, count;  ///< its rays among `candidateRays`
    };
    BoxTreeWalk walk;
    std::vector<Candidate> candidates;
    std::vector<std::uint32_t> candidateRays;

    /// Those of the batch that are `meeting`; nothing behind what is known of them will be found.
    void gather(const RayBatch& batch, const HitBatch& knownHits) {
        rays.gather(batch, meeting);
        hits.gatherLimits(knownHits, meeting);
    }
};

}  // namespace isoscope
