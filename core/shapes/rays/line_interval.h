// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shapes/hit.h"
#include "core/shapes/rays/ray.h"
#include "core/shapes/shape.h"

namespace isoscope {

/// The part of a ray's whole line (negative t too) inside a convex body, with the outward normals of the body
/// where the line enters and leaves. Empty for a miss, an empty body, a sphere of radius 0, a direction of 0
/// and numbers that are not finite.
struct LineInterval {
    RayInterval range{1, 0};
    glm::dvec3 nearNormal{1, 0, 0};
    glm::dvec3 farNormal{1, 0, 0};

    /// Whether the line misses the body; the normals mean nothing then.
    bool empty() const { return range.empty(); }
};

/// LineInterval::range alone, which costs much less.
RayInterval sphereRange(const Ray& ray, const glm::dvec3& center, double radius);
RayInterval boxRange(const Ray& ray, const glm::dvec3& low, const glm::dvec3& high);

/// The passage through a ball, with normals of unit length. A line that only touches the ball misses.
LineInterval sphereInterval(const Ray& ray, const glm::dvec3& center, double radius);
/// One of its normals alone.
glm::dvec3 sphereNormal(const Ray& ray, const glm::dvec3& center, double radius, bool entering);
/// A box between its low and high corner; flat boxes are met too.
LineInterval boxInterval(const Ray& ray, const glm::dvec3& low, const glm::dvec3& high);

/// Appends the ends of sphereInterval() that lie in `interval`; finds no other normal.
void appendSphereEnds(const Ray& ray, const glm::dvec3& center, double radius, RayInterval interval,
                      HitList& hits);

/// Takes the first end of sphereInterval() from `nearLimit` on when nothing nearer is known.
void offerSphereEnd(const Ray& ray, const glm::dvec3& center, double radius, double nearLimit,
                    NearestHit& nearest);

/// Appends the two ends of `body` that lie in `interval`.
void appendEnds(const Ray& ray, const LineInterval& body, RayInterval interval, HitList& hits);

}  // namespace isoscope
