// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/shapes/shape.h"

namespace isoscope {

/// A flat polygon with any number of outlines; a point belongs to it when an odd number of them surrounds it.
/// It contains nothing.
class Polygon : public Shape {
  public:
    /// Where POV-Ray would see an outline end: at a point equal to the one it began with. The last outline is
    /// closed by itself. Points that do not lie in one plane are projected on that of the first outline's
    /// area.
    explicit Polygon(const std::vector<glm::dvec3>& points);

    /// Whether the points span an area.
    bool usable() const { return !edges_.empty(); }

    void intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const override;
    bool contains(const glm::dvec3&, TraceContext&) const override { return false; }
    bool isPatch() const override { return true; }
    Bounds bounds() const override { return bounds_; }

  private:
    struct Edge {
        glm::dvec3 from, to;
    };

    bool covers(const glm::dvec3& point) const;

    std::vector<Edge> edges_;
    glm::dvec3 center_{0};
    glm::dvec3 normal_{0};
    int across_ = 0, along_ = 1;  ///< the two coordinates in which the polygon looks largest
    Bounds bounds_;
};

}  // namespace isoscope
