// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>

#include "core/scene/camera.h"

namespace isoscope {

/// The ray that crosses the lens of `camera` at `place`, on a disc of radius 1, and meets `ray`, which goes
/// through the middle of the lens, in the plane of focus. The same ray where there is no such plane ahead, or
/// no blur. POV-Ray's lens has a radius of a quarter of `aperture` and an even disc; measured on its
/// pictures.
Ray throughLens(const Camera& camera, const Ray& ray, const glm::dvec2& place);

}  // namespace isoscope
