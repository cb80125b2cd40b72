// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <stop_token>
#include <vector>

#include "core/mesh/contour/surface_polygons.h"

namespace isoscope {

/// Where the vertices of a surface's polygons lie.
struct VertexPlaces {
    std::vector<glm::dvec3> points;
    std::vector<glm::dvec3> normals;   ///< unit length; of a sharp vertex a mean
    std::vector<std::uint8_t> smooth;  ///< 0 at edges and corners of the surface
};

/// Fits each vertex to the crossings around it (QuadricFit), in its leaf less a margin that is far below
/// `tolerance`, so that no two vertices share a place. Smooth ones are moved along the gradient to the
/// surface.
VertexPlaces placeVertices(const SurfacePolygons& surface, const SolidField& field, const CellOctree& tree,
                           const CellSamples& samples, double tolerance, SamplerPool& samplers,
                           WorkerPool& workers, const std::stop_token& stop);

}  // namespace isoscope
