// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include "core/shapes/box_tree.h"
#include "core/shapes/shape.h"
#include "core/shapes/slab_batch.h"

namespace isoscope {

/// The rays of a batch that one object is asked about, so that it sees a dense list. Kept from batch to batch
/// for its memory.
struct GatheredRays {
    std::vector<std::uint32_t> indices;  ///< in the batch
    std::vector<Ray> rays;
    std::vector<NearestHit> nearest;

    /// The whole batch, where it has to be asked about ray by ray.
    std::vector<Ray> all;
    std::vector<NearestHit> allNearest;

    /// What is known of the whole batch: nothing that lies farther on ray i than farthest[i] counts.
    std::vector<double> farthest;
    /// Those whose boxes are tested one after another, by all rays.
    SlabBatch slabs;
    std::vector<std::uint32_t> meeting;  ///< rays that may meet the box at hand

    /// Of the many objects of a scene, those that the tree found for the batch.
    struct Candidate {
        std::uint32_t object;
        std::uint32_t first, count;  ///< its rays among `candidateRays`
    };
    BoxTreeWalk walk;
    std::vector<Candidate> candidates;
    std::vector<std::uint32_t> candidateRays;

    void clear() {
        indices.clear();
        rays.clear();
        nearest.clear();
    }
    /// Nothing beyond farthest[index] will be found.
    void add(std::uint32_t index, const Ray& ray) {
        indices.push_back(index);
        rays.push_back(ray);
        NearestHit& bound = nearest.emplace_back();
        bound.found = farthest[index] < std::numeric_limits<double>::infinity();
        bound.hit.t = farthest[index];
    }
    /// The whole batch instead of what was gathered; nothing beyond limits[i] will replace the bound of ray
    /// i.
    void addAll(std::span<const Ray> all, std::span<const double> limits) {
        indices.resize(all.size());
        std::iota(indices.begin(), indices.end(), 0U);
        rays.assign(all.begin(), all.end());
        nearest.resize(all.size());
        for (std::size_t i = 0; i < all.size(); ++i) {
            nearest[i].found = true;
            nearest[i].hit.t = limits[i];
            nearest[i].hit.material = noMaterial;
        }
    }
};

}  // namespace isoscope
