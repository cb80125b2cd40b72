// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "core/shapes/bounds.h"
#include "core/shapes/rays/ray.h"
#include "core/shapes/transform.h"

namespace isoscope {

/// Many rays seen as one: the boxes around their origins and around their directions. With it a whole batch
/// passes by a far object at the price of one ray.
class RayBundle {
  public:
    explicit RayBundle(std::span<const Ray> rays);
    /// All rays with their origin in the one box and their direction, of any length, in the other.
    RayBundle(const Bounds& origins, const Bounds& directions);

    /// The bundle as seen from the coordinates of an object (Transform::toObject); it may become wider.
    RayBundle toObject(const Transform& transform) const;

    /// False only when none of the rays meets the box at t >= 0. Rays that are not finite are never passed
    /// over.
    bool mayMeet(const Bounds& bounds) const;
    /// False only when none of the rays meets the ball at t >= 0, as mayMeet() otherwise. `radius` must not
    /// be negative.
    bool mayMeetBall(const glm::dvec3& center, double radius) const;

  private:
    Bounds origins_;
    Bounds directions_;
    bool usable_ = true;
};

}  // namespace isoscope
