// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/study/gradient/gradient_domain.h"

namespace isoscope {

/// The cells of a grid over a box, up to 64 along an axis, that a gradient study leaves out: those with a
/// place that has no bound, and their neighbours, so that everything else keeps a distance of a cell from
/// such places.
class LeftOutCells {
  public:
    LeftOutCells() = default;
    explicit LeftOutCells(const GradientBox& whole);

    /// The longest edge of a cell. Boxes that are longer are worth halving before they are left out.
    double width() const { return width_; }
    /// Leaves out the cells that `box` touches, and those around them.
    void add(const GradientBox& box);

    /// Whether nothing is left out.
    bool empty() const { return count_ == 0; }
    /// Whether a point of the box, or any, lies in what is left out.
    bool holds(const glm::dvec3& point) const;
    /// Whether all of the box does.
    bool holds(const GradientBox& box) const;
    /// The part of the whole that is left out.
    double share() const;

  private:
    struct Range {
        std::size_t first, last;
    };
    /// Of the cells that a stretch of an axis touches: all, or without those that it touches at an end alone.
    Range cells(int axis, double low, double high, bool ends) const;
    std::size_t indexOf(std::size_t x, std::size_t y, std::size_t z) const;

    GradientBox whole_;
    std::array<std::size_t, 3> counts_{1, 1, 1};
    double width_ = 0;
    std::vector<bool> leftOut_;  ///< nothing before the first
    std::size_t count_ = 0;
};

}  // namespace isoscope
