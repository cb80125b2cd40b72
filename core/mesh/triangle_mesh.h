// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace isoscope {

/// Three corners, by their numbers.
using Triangle = std::array<std::uint32_t, 3>;

/// A surface as triangles. The corners of each go round so that (b - a) x (c - a) points out of the solid.
/// Neighbours share their points, also where an edge is sharp: there the corners have normals of their own.
struct TriangleMesh {
    std::vector<glm::dvec3> points;
    std::vector<Triangle> triangles;
    std::vector<glm::dvec3> normals;      ///< unit length, out of the solid
    std::vector<Triangle> cornerNormals;  ///< for each triangle the numbers of the normals at its corners
    /// For each point 0xffRRGGBB in sRGB; empty where the surface has no colour.
    std::vector<std::uint32_t> colors;
    /// Where the triangles of each object begin: the first entry is 0, of a mesh of several there are more.
    std::vector<std::size_t> objects{0};

    /// Puts another mesh behind this one, as objects of their own. Points of a mesh without colours become
    /// white where the other has some.
    void append(const TriangleMesh& other);
    /// One normal for each point: the mean of those at its corners, by angle.
    std::vector<glm::dvec3> pointNormals() const;
    /// Moves everything by an affine map; one that mirrors turns the triangles round.
    void transform(const glm::dmat4& matrix);
};

/// What the triangles of a mesh say of its form, whatever their places.
struct MeshForm {
    std::size_t points = 0;  ///< those that some triangle uses
    std::size_t edges = 0;
    std::size_t triangles = 0;
    std::size_t pieces = 0;       ///< that hang together by points
    std::size_t borderEdges = 0;  ///< in one triangle alone
    std::size_t oddEdges = 0;     ///< in more than two triangles, or passed twice in one direction
    std::size_t oddPoints = 0;    ///< whose triangles are no single fan
    std::size_t borders = 0;      ///< closed lines of border edges

    /// Every edge is in two triangles that pass it in opposite directions.
    bool watertight() const { return triangles > 0 && borderEdges == 0 && oddEdges == 0; }
    /// Around each point the triangles form one fan, closed or with a border.
    bool manifold() const { return oddEdges == 0 && oddPoints == 0; }
    /// Points - edges + triangles.
    long euler() const {
        return static_cast<long>(points) - static_cast<long>(edges) + static_cast<long>(triangles);
    }
    /// Tunnels of all pieces together; for manifold meshes.
    long genus() const { return (2 * static_cast<long>(pieces) - static_cast<long>(borders) - euler()) / 2; }
};

/// Counts in time n log n.
MeshForm formOf(const TriangleMesh& mesh);

/// Gives each fan at a point a point of its own, so that no two fans meet in one; for meshes with borders.
void separateFans(TriangleMesh& mesh);

}  // namespace isoscope
