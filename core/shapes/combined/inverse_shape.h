// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shapes/composition.h"
#include "core/shapes/shape.h"

namespace isoscope {

/// The keyword `inverse`: inside and outside change places, normals turn over; the surface is the same, but
/// for unions, which lose the surfaces that lie inside another part, as in POV-Ray: what is cut out of a
/// shape has no walls inside. Patches have no outside, as in POV-Ray: the inverse of one contains nothing.
class InverseShape : public Shape {
  public:
    explicit InverseShape(ShapePointer shape);

    /// The shape that is not inverted, never itself an InverseShape when made by inverseOf().
    const ShapePointer& shape() const { return shape_; }

    void intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const override;
    void nearest(std::span<const Ray> rays, TraceContext& context,
                 std::span<NearestHit> nearest) const override;
    void allHits(std::span<const Ray> rays, TraceContext& context, std::span<HitList> hits) const override;
    bool contains(const glm::dvec3& point, TraceContext& context) const override;
    /// Infinite for most: a ray may be inside without ever meeting the surface.
    Bounds bounds() const override { return boundsWithin({}); }
    Bounds boundsWithin(const Bounds& room) const override { return shape_->complementWithin(room); }
    bool searchesBundles() const override { return surface_->searchesBundles(); }
    Composition composition() const override;
    ShapePointer withParts(std::vector<ShapePointer> parts, std::vector<ShapePointer> limits) const override;

  private:
    ShapePointer shape_;
    ShapePointer surface_;  ///< the same solid without inner surfaces
};

/// The shape with inside and outside changed, by POV-Ray's rules. Clips (ClippedShape) are not turned over,
/// so what they cut off is outside of both. The inverse of an inverse is the shape itself, but for what has
/// patches: of that each part is turned over, so that a union becomes an intersection, and an intersection a
/// merge.
ShapePointer inverseOf(const ShapePointer& shape);

}  // namespace isoscope
