// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <charconv>
#include <unordered_map>

#include "core/mesh/files/mesh_writers.h"

namespace isoscope {

namespace {

/// POV-Ray keeps a texture for each colour: more than so many are made fewer by leaving out bits.
constexpr std::size_t mostTextures = 4096;

void addVectors(std::string& text, const char* name, const std::vector<glm::dvec3>& vectors) {
    text += std::string("  ") + name + " {\n    " + std::to_string(vectors.size());
    for (const glm::dvec3& v : vectors) {
        std::string numbers;
        appendDecimals(numbers, v, ',');
        text += ",\n    <" + numbers.substr(1) + '>';
    }
    text += "\n  }\n";
}

void addTriangle(std::string& text, const Triangle& t) {
    text += ",\n    <" + std::to_string(t[0]) + ',' + std::to_string(t[1]) + ',' + std::to_string(t[2]) + '>';
}

std::string pigment(std::uint32_t color) {
    const auto rgb = channels(color);
    std::string numbers;
    appendDecimals(numbers, glm::dvec3(rgb[0], rgb[1], rgb[2]) / 255.0, ',');
    return "pigment { srgb <" + numbers.substr(1) + "> }";
}

/// The colours of points, as few as POV-Ray can take.
struct Textures {
    std::vector<std::uint32_t> colors;
    std::vector<std::uint32_t> numbers;  ///< of each point
};

Textures texturesOf(const std::vector<std::uint32_t>& colors) {
    for (unsigned bits = 8;; --bits) {
        const unsigned dropped = 8 - bits;
        const std::uint32_t kept = (0xffu << dropped & 0xff) * 0x010101u;
        const std::uint32_t half = dropped > 0 ? (1u << (dropped - 1)) * 0x010101u : 0;
        Textures textures;
        std::unordered_map<std::uint32_t, std::uint32_t> known;
        for (const std::uint32_t color : colors) {
            const std::uint32_t coarse = (color & kept) | half | 0xff000000;
            const auto [place, isNew] =
                known.try_emplace(coarse, static_cast<std::uint32_t>(textures.colors.size()));
            if (isNew) textures.colors.push_back(coarse);
            textures.numbers.push_back(place->second);
        }
        if (textures.colors.size() <= mostTextures || bits == 1) return textures;
    }
}

}  // namespace

MeshFile povrayMeshFile(const TriangleMesh& mesh) {
    MeshFile file;
    std::string& text = file.content;
    const Textures textures = texturesOf(mesh.colors);
    const bool colored = textures.colors.size() > 1;
    text =
        "// Exported by Isoscope; the next export to this file replaces it.\n"
        "// Use it so: #include this file, then object { Isoscope_Mesh }\n#version 3.7;\n"
        "#declare Isoscope_Mesh = mesh2 {\n";
    addVectors(text, "vertex_vectors", mesh.points);
    addVectors(text, "normal_vectors", mesh.normals);
    if (colored) {
        text += "  texture_list {\n    " + std::to_string(textures.colors.size());
        for (const std::uint32_t color : textures.colors) text += ",\n    texture { " + pigment(color) + " }";
        text += "\n  }\n";
    }
    text += "  face_indices {\n    " + std::to_string(mesh.triangles.size());
    for (const Triangle& t : mesh.triangles) {
        addTriangle(text, t);
        if (!colored) continue;
        for (const std::uint32_t point : t) text += ',' + std::to_string(textures.numbers[point]);
    }
    text += "\n  }\n  normal_indices {\n    " + std::to_string(mesh.cornerNormals.size());
    for (const Triangle& t : mesh.cornerNormals) addTriangle(text, t);
    text += "\n  }\n";
    // For a solid: any direction that is along no triangle.
    if (formOf(mesh).watertight()) text += "  inside_vector <0.3141, 0.8719, 0.3763>\n";
    if (textures.colors.size() == 1) text += "  texture { " + pigment(textures.colors[0]) + " }\n";
    text += "}\n";
    return file;
}

}  // namespace isoscope
