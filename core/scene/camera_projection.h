// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/camera.h"

namespace isoscope {

/// The ray through (u, v), as Camera::ray, of a camera whose picture is curved; its direction has any length.
/// The directions are POV-Ray 3.7.0.10's, measured by a sky whose colour tells them: fisheye,
/// ultra_wide_angle, spherical and cylinder cameras take only the directions of `right`, `up` and
/// `direction`, panoramic ones their lengths too.
Ray curvedRay(const Camera& camera, double u, double v);

/// Where the pattern of a camera's normal is asked for the ray through (u, v): the point (x, y, 0), as in
/// POV-Ray 3.7.0.10 (measured by gradients that bend the rays). For flat pictures the place itself, else
/// angles in radians, along the axis of cylinders a length. Round pictures have the direction from the
/// middle, from -pi/2 to 3 pi/2, and the angle from straight ahead; (0, 0) where they show nothing.
glm::dvec2 normalPlace(const Camera& camera, double u, double v);

}  // namespace isoscope
