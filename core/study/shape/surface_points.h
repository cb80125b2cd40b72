// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <stop_token>
#include <vector>

#include "core/shapes/isosurface/isosurface.h"

namespace isoscope {

/// The same surface, of which rays tell as many roots as POV-Ray can be asked for.
Isosurface withAllRoots(const Isosurface& surface);

/// Where rays along the axes cross the surface, `raysAlong` by `raysAlong` of them for each axis, spread over
/// the container: by the certified root finder, so that the thinnest sheets are met. Neither the container's
/// wall nor changes of sign across jumps and poles count. At most `most`, evenly taken from all; fewer after
/// a stop.
std::vector<glm::dvec3> surfacePoints(const Isosurface& surface, std::span<const double> parameters,
                                      int raysAlong = 28, std::size_t most = 3000, std::stop_token stop = {});

}  // namespace isoscope
