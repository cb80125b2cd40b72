// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/surface_normal.h"
#include "core/texture/pigment_function.h"

namespace isoscope {

/// The normal that a `normal { ... }` makes of another, as a function of the point (arguments 0 to 2) and the
/// normal there (3 to 5, of any length), with the three components of a unit vector for results. It works in
/// the coordinates in which the block is written: an object that has been moved since carries points and
/// normals there (normals by the inverse transpose) and back. Not valid when it is too large for a graph.
///
/// The formulas were found by measuring the normals of POV-Ray 3.7 through the shading of its pictures.
Function normalFunction(const SurfaceNormal& normal, const PatternSettings& settings);

}  // namespace isoscope
