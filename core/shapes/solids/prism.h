// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "core/shapes/shape.h"
#include "core/shapes/solids/plane_curve.h"

namespace isoscope {

/// How a prism differs from a closed one of the same size at every height.
struct PrismStyle {
    bool conic = false;        ///< scaled by the height instead of having one size
    bool open = false;         ///< without caps
    bool outwardCaps = false;  ///< the normal of the lower cap points down
    /// The extent is at least from statedLow to statedHigh: fonts state boxes for their letters, not always
    /// the right ones, and POV-Ray's extents are theirs.
    glm::dvec2 statedLow{std::numeric_limits<double>::infinity()};
    glm::dvec2 statedHigh{-std::numeric_limits<double>::infinity()};
};

/// Closed curves of the x-z plane swept along y (docs/povray/primitives.md, section 8): with the same size at
/// every height, or scaled by the height. Flat caps close both ends unless it is open. Normals are POV-Ray's:
/// those of both caps point up, unless the style says otherwise, those of the sides to the right of the
/// curve, whether that is outside or not.
class Prism : public Shape {
  public:
    /// The pieces of all outlines. Heights may come in any order.
    Prism(std::vector<CurvePiece> outline, double height1, double height2, const PrismStyle& style);

    void intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const override;
    bool contains(const glm::dvec3& point, TraceContext& context) const override;
    Bounds bounds() const override { return bounds_; }

  private:
    Bounds findBounds() const;
    void addStraightSide(std::size_t piece, const Ray& ray, RayInterval interval, HitList& hits) const;
    void addConicSide(std::size_t piece, const Ray& ray, RayInterval interval, HitList& hits) const;
    void addSide(std::size_t piece, double u, double t, const Ray& ray, RayInterval interval,
                 HitList& hits) const;
    void addCap(double height, const Ray& ray, RayInterval interval, HitList& hits) const;
    /// The place of the outline that (x, y, z) is swept from.
    glm::dvec2 unswept(const glm::dvec3& point) const;

    Outline outline_;
    double low_, high_;
    PrismStyle style_;
    Bounds bounds_;
};

}  // namespace isoscope
