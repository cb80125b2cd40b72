// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "core/shapes/rays/hit_batch.h"
#include "core/shapes/rays/ray_batch.h"
#include "core/shapes/rays/span_batch.h"

namespace isoscope {

// Shape::nearestInBatch and ConvexSolid::spans of simple solids, several rays at a time: the same arithmetic
// as in their Shape::intersect, to the bit. Lengths are those of the solid's own coordinates, t is in units
// of the ray's direction. Rays that are not finite, or have no direction, meet nothing; spans of such rays
// are empty or in doubt.

/// What a solid is asked.
struct SolidQuestion {
    const RayBatch& rays;
    double nearest;  ///< hits before it do not count
    bool normals;    ///< wanted
    HitBatch& hits;  ///< one for each ray; replaced where the solid is met before
};

/// The half-space's border `normal` . p = `distance`, met up to `horizon` units of length away.
void meetPlane(const glm::dvec3& normal, double distance, double horizon, const SolidQuestion& question);

/// The half-space below it: normal . p < distance. Writes all columns of `spans`, which it makes as long as
/// `rays`.
void findPlaneSpans(const glm::dvec3& normal, double distance, double horizon, const RayBatch& rays,
                    SpanBatch& spans);

/// A ball; the radius is not negative, and one of 0 is met by no ray.
void meetSphere(const glm::dvec3& center, double radius, const SolidQuestion& question);

/// The part of each ray's line in the ball; `spans` become as many as there are rays.
void findSphereSpans(const glm::dvec3& center, double radius, const RayBatch& rays, SpanBatch& spans);

/// A box, low <= high on every axis; flat ones are met, too.
void meetBox(const glm::dvec3& low, const glm::dvec3& high, const SolidQuestion& question);

/// The part of each ray's line in the box; `spans` become as many as there are rays.
void findBoxSpans(const glm::dvec3& low, const glm::dvec3& high, const RayBatch& rays, SpanBatch& spans);

/// A cone or frustum: at height h over its center, along the axis, it is as wide as middleRadius + slope h.
struct ConeForm {
    glm::dvec3 center;
    glm::dvec3 axis;  ///< unit length
    double half;      ///< of its length
    double middleRadius;
    double slope;
    double baseRadius;  ///< at height -half
    double capRadius;   ///< at height half
    bool open;
};

/// `doubtful` become the numbers of rays that have to be asked about one by one: those along the surface and
/// those whose numbers are very large or very small.
void meetCone(const ConeForm& cone, const SolidQuestion& question, std::vector<std::uint32_t>& doubtful);

/// The part of each ray's line in a cone that is closed; `spans` become as many as there are rays.
void findConeSpans(const ConeForm& cone, const RayBatch& rays, SpanBatch& spans);

}  // namespace isoscope
