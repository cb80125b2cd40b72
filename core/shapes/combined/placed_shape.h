// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shapes/composition.h"
#include "core/shapes/shape.h"
#include "core/shapes/transform.h"

namespace isoscope {

/// A shape moved by a transform, with a material for those of its hits that have none of their own.
class PlacedShape : public Shape {
  public:
    /// `transform` leads from the shape's coordinates to the outer ones.
    PlacedShape(ShapePointer shape, const Transform& transform, MaterialId material = noMaterial);

    /// A placed shape inside another one is joined with it: shape() is then the inner one's, and transform()
    /// leads from there to the outer coordinates in one step; material() is the inner one's where it has one.
    const ShapePointer& shape() const { return shape_; }
    const Transform& transform() const { return transform_; }
    MaterialId material() const { return material_; }

    void intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const override;
    void nearest(std::span<const Ray> rays, TraceContext& context,
                 std::span<NearestHit> nearest) const override;
    void nearestInBatch(const RayBatch& rays, TraceContext& context, HitBatch& hits) const override;
    void allHits(std::span<const Ray> rays, TraceContext& context, std::span<HitList> hits) const override;
    bool contains(const glm::dvec3& point, TraceContext& context) const override;
    Bounds bounds() const override { return bounds_; }
    Bounds boundsWithin(const Bounds& room) const override;
    bool searchesBundles() const override { return shape_->searchesBundles(); }
    bool mayBeMet(const RayBundle& rays) const override;
    Bounds complementWithin(const Bounds& room) const override;
    bool boundsCutIntersections() const override { return shape_->boundsCutIntersections(); }
    Composition composition() const override;
    ShapePointer withParts(std::vector<ShapePointer> parts, std::vector<ShapePointer> limits) const override;

  private:
    /// A box in outer coordinates, from what `boundsThere` answers in those of the shape.
    template <class BoundsThere>
    Bounds moved(const Bounds& room, BoundsThere boundsThere) const;
    std::vector<Ray> toObject(std::span<const Ray> rays) const;
    void place(const Ray& ray, Hit& hit) const;

    ShapePointer shape_;
    Transform transform_;
    MaterialId material_;
    bool identity_;
    Bounds bounds_;
};

}  // namespace isoscope
