// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <QString>

#include "core/study/gradient/hole_map.h"
#include "core/study/view/ray_profile.h"

namespace isoscope {

/// What happens along a ray that meets the container, in one or two sentences: whether POV-Ray's method finds
/// the surface and, if not, which interval it dismissed and why. `pictured` is the pixel in the whole
/// picture, where POV-Ray also remembers the rays before.
QString rayExplanation(const RayProfile& profile, std::optional<HolePixel> pictured);

}  // namespace isoscope
