// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

#include "core/scene/light_source.h"

namespace isoscope {

/// Where the lights of an area light are, as one point of a surface sees them. Measured on POV-Ray 3.7.0.10
/// through a pinhole.
class LightGrid {
  public:
    /// `light` has an area.
    LightGrid(const LightSource& light, const glm::dvec3& point);

    /// The place of the light in this column and row, counted from 0.
    glm::dvec3 place(int column, int row) const;

  private:
    const LightSource& light_;
    const LightArea& area_;
    glm::dvec3 point_;
    glm::dvec3 edge_, otherEdge_;
};

}  // namespace isoscope
