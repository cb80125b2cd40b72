// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/shapes/composition.h"
#include "core/shapes/shape.h"

namespace isoscope {

/// The keyword `clipped_by`: of a shape only what lies inside all of the clipping shapes. The cut stays open;
/// a point is inside when it is inside the shape and inside all clipping shapes.
class ClippedShape : public Shape {
  public:
    ClippedShape(ShapePointer shape, std::vector<ShapePointer> clips);

    /// What is cut and by what, as given.
    const ShapePointer& shape() const { return shape_; }
    const std::vector<ShapePointer>& clips() const { return clips_; }

    void intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const override;
    void nearest(std::span<const Ray> rays, TraceContext& context,
                 std::span<NearestHit> nearest) const override;
    void allHits(std::span<const Ray> rays, TraceContext& context, std::span<HitList> hits) const override;
    bool contains(const glm::dvec3& point, TraceContext& context) const override;
    Bounds bounds() const override;
    Bounds boundsWithin(const Bounds& room) const override;
    bool searchesBundles() const override { return shape_->searchesBundles(); }
    Composition composition() const override;
    ShapePointer withParts(std::vector<ShapePointer> parts, std::vector<ShapePointer> limits) const override;

  private:
    bool kept(const glm::dvec3& point, TraceContext& context) const;

    ShapePointer shape_;
    std::vector<ShapePointer> clips_;
};

}  // namespace isoscope
