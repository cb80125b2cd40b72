// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/light/surface_points.h"
#include "core/scene/light_source.h"

namespace isoscope {

/// Whether its light is as strong at all places, shadows aside.
bool spreadsEvenly(const LightSource& light);

/// Sets toLight, distance and strength of all points as POV-Ray 3.7 spreads the light of a source, shadows
/// aside: spotlight and cylinder fall off between `radius` and `falloff`, all weaken with distance when
/// fadeDistance or fadePower say so. Behind a parallel light that fades by an odd power the strength is
/// negative. Checked against POV-Ray's pictures.
void findArrival(const LightSource& light, SurfacePoints& points);

}  // namespace isoscope
