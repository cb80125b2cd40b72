// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/shapes/composition.h"
#include "core/shapes/shape.h"

namespace isoscope {

/// The keyword `bounded_by`: rays that neither start in a bounding shape nor meet it do not meet the shape,
/// even where it sticks out (as POV-Ray's trace() answers). What is inside does not depend on it. Bounds give
/// infinite shapes a finite box.
class BoundedShape : public Shape {
  public:
    /// A ray must pass every one of the limits.
    BoundedShape(ShapePointer shape, std::vector<ShapePointer> limits);

    /// What is limited and by what, as given.
    const ShapePointer& shape() const { return shape_; }
    const std::vector<ShapePointer>& limits() const { return limits_; }

    void intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const override;
    void nearest(std::span<const Ray> rays, TraceContext& context,
                 std::span<NearestHit> nearest) const override;
    void allHits(std::span<const Ray> rays, TraceContext& context, std::span<HitList> hits) const override;
    bool contains(const glm::dvec3& point, TraceContext& context) const override;
    Bounds bounds() const override { return bounds_; }
    bool searchesBundles() const override { return shape_->searchesBundles(); }
    Composition composition() const override;
    ShapePointer withParts(std::vector<ShapePointer> parts, std::vector<ShapePointer> limits) const override;

  private:
    /// The rays that pass all limits, by number.
    struct Passing {
        std::vector<std::size_t> numbers;
        std::vector<Ray> rays;
    };
    bool passes(const Ray& ray, TraceContext& context) const;
    Passing select(std::span<const Ray> rays, TraceContext& context) const;

    ShapePointer shape_;
    std::vector<ShapePointer> limits_;
    Bounds bounds_;
};

/// The shape within those of the limits that keep any ray off: a convex one around the box of the shape has
/// no effect. Without such limits it is the shape itself.
ShapePointer boundedBy(ShapePointer shape, const std::vector<ShapePointer>& limits);

}  // namespace isoscope
