// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "core/mesh/triangle_mesh.h"

namespace isoscope::test {

/// What a checker that shares no code with core/mesh finds of a mesh.
struct CheckedMesh {
    std::size_t points = 0, edges = 0, triangles = 0, pieces = 0;
    std::size_t borderEdges = 0;
    std::string fault;  ///< the first one: an edge, a fan, a number or a corner that is wrong; empty for none

    long euler() const {
        return static_cast<long>(points) - static_cast<long>(edges) + static_cast<long>(triangles);
    }
    /// Of a mesh without borders.
    long genus() const { return static_cast<long>(pieces) - euler() / 2; }
};

/// Looks whether each edge is in two triangles that pass it in opposite directions (or, with `borders`, in
/// one), whether the triangles around each point are one fan, and whether all numbers are finite and in
/// range.
CheckedMesh checkMesh(const TriangleMesh& mesh, bool borders = false);

/// The volume that the triangles enclose; negative where they face inwards.
double enclosedVolume(const TriangleMesh& mesh);

}  // namespace isoscope::test
