// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "core/shapes/isosurface/isosurface.h"

namespace isoscope {

/// Corners of the container in the coordinates of the function.
Bounds containerBounds(const Container& container);

/// A plane in the coordinates of a function, with coordinates (horizontal, vertical) of its own. Planes
/// across an axis use those of the function; a free one measures from the foot of the container's middle.
class SectionPlane {
  public:
    /// Across coordinate `axis` (0 x, 1 y, 2 z) at `position`.
    static SectionPlane across(int axis, double position);
    /// Turned by `heading` about y and raised by `tilt` towards y, in degrees, `distance` away from `center`.
    /// With both 0 it is a plane across z.
    static SectionPlane turned(const glm::dvec3& center, double heading, double tilt, double distance);

    SectionPlane() : SectionPlane(across(2, 0)) {}

    /// Whether it is turned by angles, and not across an axis.
    bool isFree() const { return axis_ < 0; }
    /// 0, 1 or 2; -1 for a free plane.
    int axis() const { return axis_; }
    /// The coordinate that is constant; for a free plane, the distance from the middle along the normal.
    double position() const { return position_; }
    double heading() const { return heading_; }
    double tilt() const { return tilt_; }
    /// Unit vectors.
    const glm::dvec3& right() const { return right_; }
    const glm::dvec3& up() const { return up_; }
    const glm::dvec3& normal() const { return normal_; }

    /// The point of these coordinates of the plane, in the coordinates of the function.
    glm::dvec3 at(double horizontal, double vertical) const {
        return origin_ + horizontal * right_ + vertical * up_;
    }
    /// Where the perpendicular through `point` meets it.
    glm::dvec2 footOf(const glm::dvec3& point) const;
    /// The point of the plane nearest to the middle of the container.
    glm::dvec3 middle(const Container& container) const;

    friend bool operator==(const SectionPlane&, const SectionPlane&) = default;

  private:
    struct Unset {};
    explicit SectionPlane(Unset) {}

    int axis_ = 2;
    double position_ = 0, heading_ = 0, tilt_ = 0;
    glm::dvec3 origin_{0}, right_{1, 0, 0}, up_{0, 1, 0}, normal_{0, 0, 1};
};

/// Heading and tilt in degrees of the plane with this normal of any length; straight up and down `heading` is
/// kept, for there it could be any.
struct PlaneAngles {
    double heading = 0;
    double tilt = 0;
};
/// A normal that is zero, or not finite, gives `heading` and tilt 0.
PlaneAngles anglesOf(const glm::dvec3& normal, double heading);

/// The part of a plane that is worth a look. It does not depend on the plane's position.
struct SectionRectangle {
    double left = -1, right = 1, bottom = -1, top = 1;
};
/// The rectangle around the container, seen along the plane's normal.
SectionRectangle rectangleOf(const SectionPlane& plane, const Container& container);

/// The positions at which a plane of this direction meets the container.
struct SectionTravel {
    double low = -1;
    double high = 1;
};
/// From the first to the last position that meets the container's box or sphere, in the terms of
/// SectionPlane::position().
SectionTravel travelOf(const SectionPlane& plane, const Container& container);

/// Corners of what the plane cuts out of the container, in the plane's coordinates; empty where it passes by.
std::vector<glm::dvec2> sectionOutline(const SectionPlane& plane, const Container& container);

}  // namespace isoscope
