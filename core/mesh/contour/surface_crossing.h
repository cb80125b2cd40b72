// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "core/mesh/contour/solid_field.h"

namespace isoscope {

/// What a way out of the solid passes.
enum class CrossingKind : std::uint8_t {
    surface,  ///< the level set
    wall,     ///< the container's wall
    jump,     ///< a discontinuity or pole of the function
};

/// A straight way from a point of the solid to one outside of it.
struct SurfaceWay {
    glm::dvec3 inside{0}, outside{0};
};

/// A place where a SurfaceWay leaves the solid; the first where the container ends, else any of them.
struct SurfaceCrossing {
    double share = 0.5;   ///< of the way, from its inside, from 0 to 1
    glm::vec3 normal{0};  ///< unit length, out of the solid
    CrossingKind kind = CrossingKind::surface;
};

/// Finds a crossing on each way, to `closeness` of its length. Normals are those of the gradient; at jumps,
/// and where there is none, they are those of the surface between crossings nearby. After Chandrupatla, "A
/// new hybrid quadratic/bisection algorithm for finding the zero of a nonlinear function without using
/// derivatives" (1997).
void findCrossings(SolidSampler& sampler, std::span<const SurfaceWay> ways, double closeness,
                   std::span<SurfaceCrossing> crossings);

}  // namespace isoscope
