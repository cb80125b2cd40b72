// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/material.h"
#include "core/scene/surface_normal.h"

namespace isoscope {

/// Whether something of this asks for more than a point of space (surface_variables.h): slopes, and places on
/// the surface. Functions cannot tell those.
bool needsSurface(const Pattern& pattern);
bool needsSurface(const Pigment& pigment);
bool needsSurface(const SurfaceNormal& normal);

/// The pigment where there is no surface, as of a sky or in a function: slopes are 0, as in POV-Ray 3.7.
Pigment withoutSlopes(Pigment pigment);

/// Whether something in it is looked up at the place on the surface (`uv_mapping`).
bool onSurface(const Pigment& pigment);
bool onSurface(const SurfaceNormal& normal);
bool onSurface(const Material& material);

/// The material with all its patterns looked up at the place on the surface.
Material laidOnSurface(Material material);

}  // namespace isoscope
