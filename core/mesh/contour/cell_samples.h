// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "core/mesh/contour/cell_octree.h"
#include "core/mesh/contour/key_table.h"
#include "core/mesh/contour/minimal_edges.h"
#include "core/mesh/contour/surface_crossing.h"

namespace isoscope {

class WorkerPool;

/// What is known of a solid at the points and edges of an octree's lattice, each found out once.
class CellSamples {
  public:
    /// At a point.
    struct Corner {
        float value = 0;  ///< g; of a shortened function only its sign is sure to be right
        bool inside = false;
    };
    /// On an edge of which one end is inside: the share is that of the way from its low end.
    struct EdgeCrossing {
        double share = 0.5;
        glm::vec3 normal{0};
        CrossingKind kind = CrossingKind::surface;
    };

    /// The references must outlive it. Crossings are found to `closeness`, a length.
    CellSamples(const SolidField& field, const CellOctree& tree, double closeness)
        : field_(field), tree_(tree), closeness_(closeness) {}

    /// Finds out what is missing at the corners of cells.
    void needCorners(std::span<const std::uint32_t> cells, SamplerPool& samplers, WorkerPool& workers,
                     const std::stop_token& stop);
    /// What is known of a point, which must be a corner of a cell that was asked for.
    const Corner& corner(const LatticePoint& point) const {
        return corners_[corners_.find(CellOctree::key(point))];
    }
    /// Which corners of a cell are inside, a bit each by their numbers; none where they were not asked for.
    unsigned cornersInside(std::uint32_t cell) const {
        return cell < cornersInside_.size() ? cornersInside_[cell] : 0;
    }
    /// Whether the low end of a minimal edge, or the high one, is inside: where no corner is known, a proof
    /// is.
    bool endInside(const MinimalEdge& edge, bool high) const;

    /// Finds out where edges are crossed, whose ends must differ.
    void needCrossings(std::span<const MinimalEdge> edges, SamplerPool& samplers, WorkerPool& workers,
                       const std::stop_token& stop);
    /// Of an edge that needCrossings() was asked for.
    const EdgeCrossing& crossing(const MinimalEdge& edge) const {
        return crossings_[crossings_.find(edge.key())];
    }
    /// Its place, in the coordinates of the function.
    glm::dvec3 placeOf(const MinimalEdge& edge, const EdgeCrossing& crossing) const;

    /// The bytes that it would hold with so many further corners, and crossings on all of so many edges,
    /// about.
    std::size_t memoryWith(std::size_t corners, std::size_t edges) const {
        return KeyTable<Corner>::memoryFor(corners_.size() + corners) +
               KeyTable<EdgeCrossing>::memoryFor(crossings_.size() + edges);
    }

  private:
    const SolidField& field_;
    const CellOctree& tree_;
    double closeness_;
    KeyTable<Corner> corners_;
    KeyTable<EdgeCrossing> crossings_;
    std::vector<std::uint8_t> cornersInside_;
};

}  // namespace isoscope
