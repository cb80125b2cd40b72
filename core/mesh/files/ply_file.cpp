// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/files/mesh_writers.h"

namespace isoscope {

MeshFile plyFile(const TriangleMesh& mesh) {
    MeshFile file;
    std::string& content = file.content;
    content = "ply\nformat binary_little_endian 1.0\ncomment Isoscope mesh\nelement vertex " +
              std::to_string(mesh.points.size()) + '\n';
    for (const char* name : {"x", "y", "z", "nx", "ny", "nz"})
        content += std::string("property float ") + name + '\n';
    if (!mesh.colors.empty())
        for (const char* name : {"red", "green", "blue"})
            content += std::string("property uchar ") + name + '\n';
    content += "element face " + std::to_string(mesh.triangles.size()) +
               "\nproperty list uchar int vertex_indices\nend_header\n";
    const std::vector<glm::dvec3> normals = mesh.pointNormals();
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        appendFloats(content, mesh.points[i]);
        appendFloats(content, normals[i]);
        if (!mesh.colors.empty())
            for (const std::uint8_t channel : channels(mesh.colors[i])) appendBytes(content, channel);
    }
    for (const Triangle& t : mesh.triangles) {
        appendBytes(content, std::uint8_t(3));
        for (const std::uint32_t corner : t) appendBytes(content, corner);
    }
    return file;
}

}  // namespace isoscope
