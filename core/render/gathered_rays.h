// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "core/shapes/box_tree.h"
#include "core/shapes/shape.h"

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
    void add(std::size_t index, const Ray& ray, const NearestHit& bound) {
        indices.push_back(static_cast<std::uint32_t>(index));
        rays.push_back(ray);
        nearest.push_back(bound);
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
