// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>

#include "core/mesh/files/mesh_file.h"
#include "core/mesh/triangle_mesh.h"

namespace isoscope {

/// Each writes a mesh as it lies; meshFile() turns it before.
MeshFile stlFile(const TriangleMesh& mesh);
MeshFile objFile(const TriangleMesh& mesh);
MeshFile plyFile(const TriangleMesh& mesh);
MeshFile threeMfFile(const TriangleMesh& mesh);
MeshFile gltfFile(const TriangleMesh& mesh);
MeshFile povrayMeshFile(const TriangleMesh& mesh);

/// Appends a number as little-endian bytes.
template <class Number>
void appendBytes(std::string& content, Number value) {
    static_assert(std::is_trivially_copyable_v<Number> && sizeof(Number) <= 4);
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof value);
    for (std::size_t k = 0; k < sizeof value; ++k) content.push_back(static_cast<char>(bits >> 8 * k & 255));
}
/// Appends the three numbers of a vector as floats.
void appendFloats(std::string& content, const glm::dvec3& v);
/// Appends numbers as shortest decimals that are read back as the same floats, each behind a separator.
void appendDecimals(std::string& content, const glm::dvec3& v, char separator);

/// The channels of a colour: red, green, blue.
inline std::array<std::uint8_t, 3> channels(std::uint32_t color) {
    return {static_cast<std::uint8_t>(color >> 16), static_cast<std::uint8_t>(color >> 8),
            static_cast<std::uint8_t>(color)};
}

/// Where object `number` of a mesh ends among its triangles.
std::size_t objectEnd(const TriangleMesh& mesh, std::size_t number);

}  // namespace isoscope
