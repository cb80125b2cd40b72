// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

#include "core/render/light/surface_points.h"

namespace isoscope {

/// Sets toLight and distance of all points for a source at a place, and strength to 1. A point at that very
/// place is 0 away, in the direction 0.
void aimAt(const glm::dvec3& location, SurfacePoints& points);

/// The same for parallel light that comes from `direction` (unit length) and begins in the plane through
/// `location`.
void aimAlong(const glm::dvec3& direction, const glm::dvec3& location, SurfacePoints& points);

}  // namespace isoscope
