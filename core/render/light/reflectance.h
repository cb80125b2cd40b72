// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

#include "core/scene/material.h"

namespace isoscope {

/// Share of the light that glass mirrors, by Fresnel's formulas, whose ior is `ratio` times that of the space
/// before it, where the ray meets the normal at an angle with this cosine. 1 where all of it is mirrored.
double fresnel(double ratio, double cosine);

/// What a finish mirrors of the light from the mirrored direction, channel by channel, as POV-Ray 3.7 has it
/// (measured): `cosine` and `ratio` as for fresnel(), `pigment` tints metals.
glm::dvec3 reflectance(const Finish& finish, const glm::dvec3& pigment, double cosine, double ratio);

/// What the thin film of a finish (`irid`), as thick as `thickness`, makes of mirrored light, channel by
/// channel, as POV-Ray 3.7 has it (measured): the cosines of the angles of light and view add up to
/// `cosines`.
glm::dvec3 filmShare(const Finish& finish, double thickness, double cosines, const glm::dvec3& wavelengths);

}  // namespace isoscope
