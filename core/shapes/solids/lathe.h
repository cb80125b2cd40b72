// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "core/roots/polynomial/root_choice.h"
#include "core/shapes/rays/centered_ray.h"
#include "core/shapes/shape.h"
#include "core/shapes/solids/plane_curve.h"

namespace isoscope {

/// A curve of (radius, height) turned about the y axis (docs/povray/primitives.md, section 7). Inside are the
/// points whose (radius, height) the curve surrounds; of a curve that is not closed those within its heights
/// that lie between its least radius and the curve, as in POV-Ray.
class Lathe : public Shape {
  public:
    explicit Lathe(std::vector<CurvePiece> curve, RootChoice choice = RootChoice::isolation);

    void intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const override;
    bool contains(const glm::dvec3& point, TraceContext& context) const override;
    Bounds bounds() const override { return {{-radius_, low_, -radius_}, {radius_, high_, radius_}}; }
    std::optional<glm::dvec2> surfacePlace(const glm::dvec3& point) const override;

  private:
    struct Extent {
        double low, high;  ///< of heights
        double radius;     ///< largest
    };
    /// A ray as the lathe sees it: height + s climb, and the square of the radius.
    struct Profile {
        double height, climb;
        double a, b, c;  ///< radius^2 = a s^2 + b s + c
    };
    /// A place on a piece, and how far along the ray it is.
    struct Place {
        double u, s;
    };

    void meetPiece(const CurvePiece& piece, const Profile& ray, std::vector<Place>& places) const;
    void meetSlanted(const CurvePiece& piece, const Profile& ray, std::vector<Place>& places) const;
    void meetLevel(const CurvePiece& piece, const Profile& ray, std::vector<Place>& places) const;

    Outline outline_;
    RootChoice choice_;
    std::vector<Extent> extents_;
    double low_ = 0, high_ = 0, radius_ = 0;
    double hollow_ = std::numeric_limits<double>::infinity();  ///< the least radius of the curve
};

}  // namespace isoscope
