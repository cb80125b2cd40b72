// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "core/shapes/shape.h"

namespace isoscope {

/// A flat triangle, shaded flat or with normals interpolated between its corners. It contains nothing. Its
/// own normal has the direction of (c - a) x (b - a), as in POV-Ray.
class Triangle : public Shape {
  public:
    using Corners = std::array<glm::dvec3, 3>;

    explicit Triangle(const Corners& corners, const std::optional<Corners>& normals = {});

    /// Whether the corners lie on one line, or are not finite: POV-Ray leaves such triangles out.
    static bool degenerate(const Corners& corners);

    void intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const override;
    bool contains(const glm::dvec3&, TraceContext&) const override { return false; }
    bool isPatch() const override { return true; }
    Bounds bounds() const override;

  private:
    Corners corners_;
    Corners normals_;
    bool smooth_;
};

}  // namespace isoscope
