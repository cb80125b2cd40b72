// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "core/shapes/rays/centered_ray.h"
#include "core/shapes/shape.h"

namespace isoscope {

/// `sor`: between the heights of two neighbouring points the square of the radius is a cubic of the height
/// (docs/povray/primitives.md, section 11). Flat discs close both ends unless it is open.
class SurfaceOfRevolution : public Shape {
  public:
    /// At least four points (radius, height); the first and the last only set slopes. The heights of the
    /// others rise: usable() tells.
    SurfaceOfRevolution(std::span<const glm::dvec2> points, bool open);

    /// Whether there are four points and the heights rise.
    static bool usable(std::span<const glm::dvec2> points);

    void intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const override;
    bool contains(const glm::dvec3& point, TraceContext& context) const override;
    Bounds bounds() const override;
    std::optional<glm::dvec2> surfacePlace(const glm::dvec3& point) const override;

  private:
    /// squared radius = c[0] + c[1] k + c[2] k^2 + c[3] k^3, k the height above `low`.
    struct Segment {
        double low, high;
        double c[4];

        double square(double height) const;
        double slope(double height) const;
    };

    void addSegment(const Segment& segment, const Ray& ray, const CenteredRay& line, RayInterval interval,
                    HitList& hits) const;
    void addCap(double height, double square, double up, const Ray& ray, RayInterval interval,
                HitList& hits) const;

    std::vector<Segment> segments_;
    double radius_ = 0;
    bool open_;
};

}  // namespace isoscope
