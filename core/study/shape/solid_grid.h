// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <stop_token>
#include <vector>

#include "core/shapes/isosurface/isosurface.h"

namespace isoscope {

/// What a solid is made of.
struct SolidCount {
    std::int64_t pieces = 0;   ///< that hang together
    std::int64_t tunnels = 0;  ///< through them: 1 for a ring
    std::int64_t hollows = 0;  ///< shut in
    bool known = false;        ///< false after a stop, and for containers that are not finite

    friend bool operator==(const SolidCount&, const SolidCount&) = default;
};

/// Signs of an isosurface on a grid over its container: what is inside is the solid, what lies outside of the
/// container is not. Tetrahedra between the grid's points (six in each cell, along one diagonal) make a solid
/// of these signs, which is counted without ambiguity: pieces and hollows by what hangs together, tunnels by
/// Euler's characteristic. What is smaller than a cell may be missed.
class SolidGrid {
  public:
    /// `cells`: along the container's longest side, 2 to mostCells; along the others in proportion.
    SolidGrid(const Isosurface& surface, std::span<const double> parameters, int cells,
              std::stop_token stop = {});
    static constexpr int mostCells = 256;

    /// False after a stop, and for containers that are not finite: then there is nothing to ask for.
    bool known() const { return known_; }
    /// Cells along each axis.
    const glm::ivec3& cells() const { return cells_; }
    /// Of the container's box; a cell is its share.
    const glm::dvec3& low() const { return low_; }
    const glm::dvec3& high() const { return high_; }
    /// The place of a point, 0 to cells() along each axis.
    glm::dvec3 place(const glm::ivec3& point) const;
    /// f - threshold there, turned so that the solid is negative; +infinity outside of the container, and
    /// where f is not a number.
    double value(const glm::ivec3& point) const { return values_[indexOf(point)]; }
    bool inside(const glm::ivec3& point) const { return value(point) < 0; }

    /// What the solid of the signs is made of.
    SolidCount count() const;

  private:
    std::size_t indexOf(const glm::ivec3& point) const {
        const auto w = static_cast<std::size_t>(cells_.x + 1), h = static_cast<std::size_t>(cells_.y + 1);
        return (static_cast<std::size_t>(point.z) * h + static_cast<std::size_t>(point.y)) * w +
               static_cast<std::size_t>(point.x);
    }

    glm::ivec3 cells_{0};
    glm::dvec3 low_{0}, high_{0};
    std::vector<double> values_;
    bool known_ = false;
};

}  // namespace isoscope
