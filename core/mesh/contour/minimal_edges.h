// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>

#include "core/mesh/contour/cell_octree.h"

namespace isoscope {

/// An edge of the smallest leaf around it, and the leaves around it.
struct MinimalEdge {
    LatticePoint low;  ///< its end with the smaller coordinate along `axis`
    std::uint8_t axis = 0;
    std::int8_t level = 0;  ///< of the smallest leaf
    /// Round the axis by the right-hand rule. A leaf that takes two quarters stands there twice, side by
    /// side.
    std::array<std::uint32_t, 4> cells{};

    /// The other end.
    LatticePoint high() const {
        LatticePoint end = low;
        end[axis] += std::uint32_t(1) << (CellOctree::deepest - level);
        return end;
    }
    /// The number of the corner at one of its ends, in a leaf of its level around it.
    unsigned endIn(const Cell& leaf, bool high) const {
        unsigned number = high ? 1u << axis : 0;
        for (unsigned other = 0; other < 3; ++other)
            if (low[other] != leaf.low[other]) number |= 1u << other;
        return number;
    }
    /// Different for all edges of all levels.
    std::uint64_t key() const;
};

/// What the leaves in a cell have, a bit each: corners outside of the solid, corners inside, and being asked
/// for.
enum CellMark : std::uint8_t { markedOutside = 1, markedInside = 2, markedAsked = 4, markedFully = 7 };

/// Calls visit(edge) for every minimal edge around which leaves with all the marks are, in an order that
/// depends on the tree alone. `marks` has a CellMark of each leaf; those of the other cells are set here.
/// After Ju, Losasso, Schaefer and Warren, "Dual contouring of Hermite data" (2002).
void forEachMinimalEdge(const CellOctree& tree, std::span<std::uint8_t> marks,
                        const std::function<void(const MinimalEdge&)>& visit);

}  // namespace isoscope
