// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/shapes/rays/hit_batch.h"
#include "core/shapes/rays/ray_batch.h"
#include "core/shapes/rays/slab_batch.h"

namespace isoscope {

/// The rays of a batch that one of several shapes is asked about, as a batch of their own. Keeps its memory.
struct RaySelection {
    SlabBatch slabs;                     ///< of the whole batch
    std::vector<std::uint32_t> meeting;  ///< numbers of the rays that may meet the box of the shape at hand
    RayBatch rays;                       ///< these rays, after gather()
    HitBatch hits;                       ///< theirs

    /// Nothing behind what is known of the rays will be found.
    void gather(const RayBatch& batch, const HitBatch& known) {
        rays.gather(batch, meeting);
        hits.gatherLimits(known, meeting);
    }
};

}  // namespace isoscope
