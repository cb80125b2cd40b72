// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <vector>

#include "core/numeric/interval.h"
#include "core/numeric/slope_range.h"
#include "core/shapes/isosurface/isosurface.h"

namespace isoscope {

/// A box with sides along the axes, in the coordinates of the function; low is at most high.
struct GradientBox {
    glm::dvec3 low{0};
    glm::dvec3 high{0};

    /// Without overflow for any finite corners.
    glm::dvec3 center() const { return 0.5 * low + 0.5 * high; }
    /// Along the longest axis.
    double width() const;
    std::array<Interval, 3> intervals() const;
    /// Along each axis, from a point to the box: holds both ends.
    std::array<SlopeRange, 3> waysFrom(const glm::dvec3& point) const;
};

/// The container of an isosurface as a gradient study sees it: a box, and a ball in it when the container is
/// a sphere, or what strips leave of it. Corners in any order; what is not finite is an empty domain.
class GradientDomain {
  public:
    /// The points p with low <= direction . p <= high; a direction is a unit vector or nearly.
    struct Strip {
        glm::dvec3 direction;
        double low, high;
    };

    explicit GradientDomain(const Container& container);
    /// What is in the box and in each of the strips.
    GradientDomain(const ContainerBox& box, std::vector<Strip> strips);

    /// The part of it in the plane across an axis through the middle of its box.
    GradientDomain flattened(int axis) const;

    /// The container's box; for a ball the box around it, rounded outwards. Meaningless for an empty domain.
    const GradientBox& box() const { return box_; }
    bool isBall() const { return isBall_; }
    bool empty() const { return empty_; }
    /// Of a ball, else 0. The radius is never negative.
    const glm::dvec3& ballCenter() const { return center_; }
    double radius() const { return radius_; }

    /// Certainly inside, walls included.
    bool contains(const glm::dvec3& point) const;
    /// Certainly has no point in common.
    bool misses(const GradientBox& box) const;
    /// Lies completely inside.
    bool encloses(const GradientBox& box) const;
    /// The nearest point inside, or almost.
    glm::dvec3 nearest(const glm::dvec3& point) const;
    /// An upper bound of d.(p - from) over the points p of the domain in `box`, for every d in `direction`.
    double advance(const std::array<SlopeRange, 3>& direction, const GradientBox& box,
                   const glm::dvec3& from) const;

  private:
    GradientBox box_;
    std::vector<Strip> strips_;
    glm::dvec3 center_{0};
    double radius_ = 0;
    bool isBall_ = false;
    bool empty_ = false;
};

}  // namespace isoscope
