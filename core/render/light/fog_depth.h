// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

#include "core/scene/fog.h"
#include "core/shapes/rays/ray.h"

namespace isoscope {

/// How much fog lies on a ray of unit direction up to a distance, which may be infinite: 1 dims light to 1/e.
/// After POV-Ray 3.7 (measured): above its offset ground fog has the density 1 / (1 + (height / altitude)^2);
/// `turbulence` is that at turbulencePlace(), unused where the fog has none. Finite or infinite, never
/// NaN.
double fogDepth(const Fog& fog, const Ray& ray, double distance, double turbulence);

/// Where turbulence (docs/povray/noise.md, section 7) is looked up: half way, and scaled.
glm::dvec3 turbulencePlace(const Fog& fog, const Ray& ray, double distance);

/// How much of the light that the fog leaves on such a way comes through unscattered: between
/// Fog::color.transmit and 1. NaN where the depth is none.
double leftByFog(const Fog& fog, const Ray& ray, double distance, double turbulence);

/// The same share of red, green and blue, which the fog may filter.
glm::dvec3 filteredByFog(const Fog& fog, double left);

}  // namespace isoscope
