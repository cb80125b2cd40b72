// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/render/light/surface_points.h"
#include "core/scene/light_source.h"
#include "core/shapes/rays/ray.h"

namespace isoscope {

/// Whether its light is as strong at all places, shadows aside.
bool spreadsEvenly(const LightSource& light);

/// Sets toLight, distance and strength of all points as POV-Ray 3.7 spreads the light of a source, shadows
/// aside: spotlight and cylinder fall off between `radius` and `falloff`, all weaken with distance when
/// fadeDistance or fadePower say so. Behind a parallel light that fades by an odd power the strength is
/// negative. Checked against POV-Ray's pictures.
void findArrival(const LightSource& light, SurfacePoints& points);

/// A part of a ray that lies in the beam of a light.
struct BeamStretch {
    double from, to;
};

/// Appends the stretches of the ray between 0 and `distance` that a spotlight or cylinder light may reach,
/// shadows aside: those within its `falloff`. Other lights have no beam.
void addBeamStretches(const LightSource& light, const Ray& ray, double distance,
                      std::vector<BeamStretch>& stretches);

}  // namespace isoscope
