// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <stop_token>
#include <vector>

#include "core/mesh/contour/polygon_mesh.h"

namespace isoscope {

/// How far a mesh and the surface are from each other, as samples tell: of the mesh the middles of triangles
/// and of their sides, of the surface the crossings of edges. That the surface is near a sample of the mesh
/// is certain: the solid begins or ends between it and a point so far off, or a crossing is so near. Between
/// the samples nothing is proven.
struct MeshDistance {
    double most = 0;  ///< of all samples
    std::size_t samples = 0;
    std::vector<std::uint32_t> failing;  ///< polygons with a sample that is further off than the tolerance
};

/// Measures with many threads; the answer does not depend on their number. What a stop leaves out counts as
/// near.
MeshDistance measureDistance(const PolygonMesh& mesh, double tolerance, SamplerPool& samplers,
                             WorkerPool& workers, const std::stop_token& stop);

}  // namespace isoscope
