// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh/contour/cell_octree.h"
#include "core/mesh/contour/cell_samples.h"
#include "core/mesh/contour/minimal_edges.h"

namespace isoscope {

/// The form of the surface in an octree, without places: a polygon for each minimal edge with one end inside,
/// with a vertex in each leaf around it. Where the edges of a leaf belong to several sheets, it has a vertex
/// for each.
///
/// The polygons are a closed manifold, whatever the tree and the signs at its points are. For think of a
/// point on each such edge, and of lines across the faces between leaves from point to point, an even number
/// of ends on each face. In each leaf the lines form closed curves, and a disc spans each of them. Two discs
/// meet at each line, and around each point there is one ring of discs. The polygons are the dual of these
/// discs. (Dual marching cubes, after Nielson 2004, on octrees; docs/mesh.md.)
struct SurfacePolygons {
    static constexpr std::uint32_t none = ~std::uint32_t(0);

    /// What one edge makes.
    struct Polygon {
        MinimalEdge edge;
        bool lowInside = false;
        /// By quarters round the edge; where a leaf takes two, `none` for the second.
        std::array<std::uint32_t, 4> vertices{none, none, none, none};
        /// Between a quarter's vertex and the next one: the number of a further vertex there, `none` mostly.
        /// Two edges that would have both ends in common are kept apart by theirs.
        std::array<std::uint32_t, 4> middles{none, none, none, none};
    };
    /// A corner of a polygon.
    struct Corner {
        std::uint32_t polygon = 0;
        std::uint8_t quarter = 0;
    };

    std::vector<Polygon> polygons;
    std::vector<std::uint32_t> cells;        ///< the leaf of each vertex
    std::vector<std::uint32_t> firstCorner;  ///< of each vertex in `corners`, and one more
    std::vector<Corner> corners;
    std::vector<std::array<std::uint32_t, 2>> middles;  ///< of each further vertex: whose two polygons

    /// What is between the corners of one vertex and those of the next.
    std::size_t vertexCount() const { return cells.size(); }
};

/// Finds the polygons. The corners of all unproven leaves must be known. Where some `leaves` are named, those
/// around them alone: other leaves then lack vertices.
SurfacePolygons findPolygons(const CellOctree& tree, const CellSamples& samples, SamplerPool& samplers,
                             std::span<const std::uint32_t> leaves = {});
/// The leaves with a polygon whose form may have changed since the tree had `before` cells: those around
/// edges of the cells that came after, whose vertices may have moved, and those around edges of these.
std::vector<std::uint32_t> leavesAround(const CellOctree& tree, std::size_t before);

}  // namespace isoscope
