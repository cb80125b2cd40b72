// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "core/shapes/bounds.h"
#include "core/shapes/ray.h"

namespace isoscope {

/// Many rays seen as one: the boxes around their origins and around their directions. With it a whole batch
/// passes by a far object at the price of one ray.
class RayBundle {
  public:
    explicit RayBundle(std::span<const Ray> rays);

    /// False only when none of the rays meets the box at t >= 0. Rays that are not finite are never passed
    /// over.
    bool mayMeet(const Bounds& bounds) const;

  private:
    Bounds origins_;
    Bounds directions_;
    bool usable_ = true;
};

}  // namespace isoscope
