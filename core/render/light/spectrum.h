// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

namespace isoscope {

/// White light taken apart as POV-Ray 3.7 does it for `dispersion` (measured on its pictures): a place in the
/// spectrum is 0 for violet and 1 for red.

/// The share of red, green and blue light between two places.
glm::dvec3 spectralColor(double from, double to);

/// The ior of a place, where `ior` is that of the middle and `dispersion` the ratio of violet's to red's.
double spectralIor(double ior, double dispersion, double place);

}  // namespace isoscope
