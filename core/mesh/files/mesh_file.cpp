// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/files/mesh_file.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <glm/mat4x4.hpp>
#include <new>

#include "core/mesh/files/mesh_writers.h"

namespace isoscope {

namespace {

/// From POV-Ray's axes.
glm::dmat4 turnTo(MeshAxes axes) {
    glm::dmat4 matrix(1);
    if (axes == MeshAxes::yUp) matrix[2][2] = -1;
    if (axes == MeshAxes::zUp) {
        matrix[1] = {0, 0, 1, 0};
        matrix[2] = {0, 1, 0, 0};
    }
    return matrix;
}

MeshFile write(const TriangleMesh& mesh, MeshFormat format) {
    switch (format) {
        case MeshFormat::stl: return stlFile(mesh);
        case MeshFormat::obj: return objFile(mesh);
        case MeshFormat::ply: return plyFile(mesh);
        case MeshFormat::threeMf: return threeMfFile(mesh);
        case MeshFormat::gltf: return gltfFile(mesh);
        case MeshFormat::povray: break;
    }
    return povrayMeshFile(mesh);
}

}  // namespace

std::optional<MeshFormat> meshFormat(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (ending == ".stl") return MeshFormat::stl;
    if (ending == ".obj") return MeshFormat::obj;
    if (ending == ".ply") return MeshFormat::ply;
    if (ending == ".3mf") return MeshFormat::threeMf;
    if (ending == ".glb") return MeshFormat::gltf;
    if (ending == ".inc" || ending == ".pov") return MeshFormat::povray;
    return {};
}

MeshAxes usualAxes(MeshFormat format) {
    switch (format) {
        case MeshFormat::stl:
        case MeshFormat::ply:
        case MeshFormat::threeMf: return MeshAxes::zUp;
        case MeshFormat::obj:
        case MeshFormat::gltf: return MeshAxes::yUp;
        case MeshFormat::povray: break;
    }
    return MeshAxes::povray;
}

std::size_t bytesOfTriangle(MeshFormat format) {
    switch (format) {
        case MeshFormat::stl: return 50;
        case MeshFormat::obj: return 110;
        case MeshFormat::ply: return 40;
        case MeshFormat::threeMf: return 375;
        case MeshFormat::gltf: return 190;
        case MeshFormat::povray: break;
    }
    return 220;
}

MeshFile meshFile(TriangleMesh mesh, MeshFormat format, MeshAxes axes) {
    try {
        mesh.transform(turnTo(axes));
        // Left-handed coordinates turn a triangle's corners the other way round: POV-Ray does not mind.
        return write(mesh, format);
    } catch (const std::bad_alloc&) {
        return {{}, "there is not enough memory for the file"};
    }
}

MeshFile meshFile(TriangleMesh mesh, MeshFormat format) {
    return meshFile(std::move(mesh), format, usualAxes(format));
}

void appendFloats(std::string& content, const glm::dvec3& v) {
    for (int k = 0; k < 3; ++k) appendBytes(content, static_cast<float>(v[k]));
}

void appendDecimals(std::string& content, const glm::dvec3& v, char separator) {
    std::array<char, 32> digits;
    for (int k = 0; k < 3; ++k) {
        const float value = static_cast<float>(v[k]) + 0.0f;
        const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value);
        content.push_back(separator);
        content.append(digits.data(), end.ptr);
    }
}

std::size_t objectEnd(const TriangleMesh& mesh, std::size_t number) {
    return number + 1 < mesh.objects.size() ? mesh.objects[number + 1] : mesh.triangles.size();
}

}  // namespace isoscope
