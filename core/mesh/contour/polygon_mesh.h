// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <stop_token>
#include <vector>

#include "core/mesh/contour/surface_polygons.h"
#include "core/mesh/triangle_mesh.h"

namespace isoscope {

/// The triangles of a surface's polygons, and which polygon each belongs to.
struct PolygonMesh {
    TriangleMesh mesh;
    std::vector<std::uint32_t> polygonOf;
    /// For each polygon how far the triangles are from the place where its edge is crossed; the container's
    /// wall is left out where it is open.
    std::vector<double> offCrossing;
    /// Where the edge of each polygon is crossed: a point of the surface.
    std::vector<glm::dvec3> crossings;
};

/// Places the vertices and cuts the polygons into triangles. Vertices lie in their leaves, where the tangent
/// planes at the crossings meet; on smooth parts they are moved to the surface itself. Two triangles stand
/// for four corners, or four around the crossing where those would be further than `tolerance` / 2 from it.
PolygonMesh makeTriangles(const SurfacePolygons& surface, const SolidField& field, const CellOctree& tree,
                          const CellSamples& samples, double tolerance, SamplerPool& samplers,
                          WorkerPool& workers, const std::stop_token& stop);

/// How far a point is from a triangle.
double distanceToTriangle(const glm::dvec3& point, const glm::dvec3& a, const glm::dvec3& b,
                          const glm::dvec3& c);

}  // namespace isoscope
