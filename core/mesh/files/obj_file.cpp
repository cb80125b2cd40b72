// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/files/mesh_writers.h"

namespace isoscope {

MeshFile objFile(const TriangleMesh& mesh) {
    MeshFile file;
    std::string& text = file.content;
    text = "# Isoscope mesh\n";
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        text += 'v';
        appendDecimals(text, mesh.points[i], ' ');
        // Colours behind the coordinates are no part of the notation; most programs read them, others stop
        // at the third number.
        if (!mesh.colors.empty()) {
            const auto rgb = channels(mesh.colors[i]);
            appendDecimals(text, glm::dvec3(rgb[0], rgb[1], rgb[2]) / 255.0, ' ');
        }
        text += '\n';
    }
    for (const glm::dvec3& normal : mesh.normals) {
        text += "vn";
        appendDecimals(text, normal, ' ');
        text += '\n';
    }
    for (std::size_t object = 0; object < mesh.objects.size(); ++object) {
        text += "o isosurface_" + std::to_string(object + 1) + '\n';
        for (std::size_t t = mesh.objects[object]; t < objectEnd(mesh, object); ++t) {
            text += 'f';
            for (std::size_t k = 0; k < 3; ++k)
                text += ' ' + std::to_string(mesh.triangles[t][k] + 1) + "//" +
                        std::to_string(mesh.cornerNormals[t][k] + 1);
            text += '\n';
        }
    }
    return file;
}

}  // namespace isoscope
