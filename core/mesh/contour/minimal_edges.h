// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>

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
    /// Different for all edges of all levels.
    std::uint64_t key() const;
};

/// Calls visit(edge) for every minimal edge between leaves that are not all proven to have one sign, in an
/// order that depends on the tree alone. After Ju, Losasso, Schaefer and Warren, "Dual contouring of Hermite
/// data" (2002).
void forEachMinimalEdge(const CellOctree& tree, const std::function<void(const MinimalEdge&)>& visit);

}  // namespace isoscope
