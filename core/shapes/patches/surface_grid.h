// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/shapes/patches/mesh.h"

namespace isoscope {

/// A rectangular net of points, columns + 1 by rows + 1 of them, that two triangles fill between four each.
struct SurfaceGrid {
    int columns = 0;
    int rows = 0;
    std::vector<glm::dvec3> points;   ///< row by row
    std::vector<glm::dvec3> normals;  ///< as many as points, or none for a surface with edges

    static constexpr std::size_t pointLimit = std::size_t{1} << 22;

    /// The index in `points` (and in `normals`) for column 0 to columns and row 0 to rows, both included.
    std::size_t number(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns + 1) +
               static_cast<std::size_t>(column);
    }
    /// The triangles, but for those without area and those with a corner that is not finite.
    std::vector<std::array<std::uint32_t, 3>> triangles() const;
    /// Gives each point the average normal of the triangles around it; points at the same place (seams,
    /// poles) are one.
    void smoothen();
    /// Null when no triangle is left.
    std::shared_ptr<const Mesh> mesh(std::optional<glm::dvec3> insideDirection = {}) const;
};

}  // namespace isoscope
