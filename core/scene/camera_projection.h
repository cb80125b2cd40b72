// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/camera.h"

namespace isoscope {

/// The ray through (u, v), as Camera::ray, of a camera whose picture is curved; its direction has any length.
/// The directions are POV-Ray 3.7.0.10's, measured by a sky whose colour tells them: fisheye,
/// ultra_wide_angle, spherical and cylinder cameras take only the directions of `right`, `up` and
/// `direction`, panoramic ones their lengths too.
Ray curvedRay(const Camera& camera, double u, double v);

}  // namespace isoscope
