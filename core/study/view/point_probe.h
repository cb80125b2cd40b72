// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <stop_token>

#include "core/render/light/object_tracer.h"
#include "core/scene/scene.h"

namespace isoscope {

/// What the function of an isosurface is at one point.
struct ProbedPoint {
    std::size_t isosurface = 0;
    glm::dvec3 place{0};    ///< in the coordinates of the function
    glm::dvec3 inScene{0};  ///< the same in the world
    double value = 0;       ///< f, without the threshold; NaN where it is undefined
    double slope = 0;  ///< |grad f|, finite or infinite, in the coordinates of the function; NaN with `value`
    double threshold = 0;
    double maxGradient = 0;  ///< the setting in force, which POV-Ray measures slopes by
    bool contained = true;   ///< inside the container, or on its wall

    /// surfaceDistance() of the point.
    double distance() const;
};

/// Looks at points of a scene one at a time: what isosurfaces' functions are there, and whether a point can
/// be seen. Keeps what that needs; one object per thread.
class PointProbe {
  public:
    /// `scene` is not null.
    explicit PointProbe(std::shared_ptr<const Scene> scene);

    /// What is looked at.
    const std::shared_ptr<const Scene>& scene() const { return scene_; }
    /// At `place`, in the coordinates of the function. Nothing without such an isosurface, for a place that
    /// is not finite, and when stopped.
    std::optional<ProbedPoint> at(std::size_t isosurface, const glm::dvec3& place,
                                  std::stop_token stop = {}) const;
    /// At what the ray, in the world, meets first: of the isosurface that is nearest there, measured by
    /// surfaceDistance(), among those whose containers hold the point. Nothing where there is none.
    std::optional<ProbedPoint> seenAlong(const Ray& ray, std::stop_token stop = {}) const;
    /// Whether anything visible lies in front of `point`, in the world, on `ray`, which passes through it.
    bool hides(const Ray& ray, const glm::dvec3& point, std::stop_token stop = {}) const;

  private:
    /// What the ray meets first; nothing for none.
    std::optional<double> firstHit(const Ray& ray, const std::stop_token& stop) const;

    std::shared_ptr<const Scene> scene_;
    ObjectTracer objects_;
};

/// The parameter of the point of the ray that is nearest to `point`; 0 for a ray without direction.
double nearestOnRay(const Ray& ray, const glm::dvec3& point);

}  // namespace isoscope
