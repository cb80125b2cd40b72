// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <glm/geometric.hpp>

#include "core/mesh/files/mesh_writers.h"

namespace isoscope {

MeshFile stlFile(const TriangleMesh& mesh) {
    constexpr std::size_t headerSize = 80;
    MeshFile file;
    // "solid" at the beginning would make readers take it for text.
    file.content = "Isoscope mesh, binary STL";
    file.content.resize(headerSize, ' ');
    file.content.reserve(headerSize + 4 + 50 * mesh.triangles.size());
    appendBytes(file.content, static_cast<std::uint32_t>(mesh.triangles.size()));
    for (const Triangle& t : mesh.triangles) {
        const glm::dvec3 &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
        const glm::dvec3 normal = glm::cross(b - a, c - a);
        const double length = glm::length(normal);
        appendFloats(file.content, length > 0 ? normal / length : glm::dvec3(0));
        for (const std::uint32_t corner : t) appendFloats(file.content, mesh.points[corner]);
        appendBytes(file.content, std::uint16_t(0));
    }
    return file;
}

}  // namespace isoscope
