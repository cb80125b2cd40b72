// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/shapes/combined/convex_intersection.h"
#include "core/shapes/composition.h"
#include "core/shapes/rays/bvh.h"
#include "core/shapes/shape.h"

namespace isoscope {

/// The set operations of the scene language: which surfaces of the parts the solid shows.
enum class CsgOperation {
    union_,        ///< everything, inner surfaces included
    merge,         ///< everything but the surfaces inside another part
    intersection,  ///< what all parts share
    difference,    ///< the first part without the others
};

/// Parts joined by set operations. From `treeLimit` parts on, unions and merges look for the parts near a ray
/// in a tree. Each hit keeps the material of its part; where a part is cut away, its
/// surface shows with the normal turned over, out of what is left. Where surfaces of parts coincide, one of
/// them bounds the solid, and it is the one that POV-Ray shows. No parts make an empty shape.
class Csg : public Shape {
  public:
    static constexpr std::size_t treeLimit = 16;

    /// For `difference` the parts after the first become their inverseOf().
    Csg(CsgOperation operation, std::vector<ShapePointer> parts);

    /// The operation as given; of a difference, parts() behind the first are inverted already.
    CsgOperation operation() const { return operation_; }
    const std::vector<ShapePointer>& parts() const { return parts_; }

    void intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const override;
    void nearest(std::span<const Ray> rays, TraceContext& context,
                 std::span<NearestHit> nearest) const override;
    void nearestInBatch(const RayBatch& rays, TraceContext& context, HitBatch& hits) const override;
    void allHits(std::span<const Ray> rays, TraceContext& context, std::span<HitList> hits) const override;
    bool contains(const glm::dvec3& point, TraceContext& context) const override;
    Bounds bounds() const override { return bounds_; }
    Bounds boundsWithin(const Bounds& room) const override;
    bool searchesBundles() const override { return searchesBundles_; }
    Composition composition() const override;
    ShapePointer withParts(std::vector<ShapePointer> parts, std::vector<ShapePointer> limits) const override;

  private:
    /// The rays that may meet a part before `farthest(index of the ray)`.
    struct Selection {
        std::vector<std::size_t> indices;
        std::vector<Ray> rays;
    };

    bool grows() const { return operation_ == CsgOperation::union_ || operation_ == CsgOperation::merge; }
    /// Whether the tree decides which parts a ray is shown to.
    bool hasTree() const { return !inTree_.empty(); }
    void buildBvh();
    /// nearest() by way of the tree, for the parts that are in it.
    void nearestInTree(std::span<const Ray> rays, TraceContext& context, std::span<NearestHit> nearest) const;
    enum class Wanted {
        all,
        nearest,  ///< it, and what lies on the same surface; perhaps others
    };
    /// intersect(), for as many hits as are wanted.
    void find(const Ray& ray, RayInterval interval, Wanted wanted, TraceContext& context,
              HitList& hits) const;
    /// nearestInBatch() of a union without a tree: part by part.
    void nearestOfParts(const RayBatch& rays, TraceContext& context, HitBatch& hits) const;
    /// nearest() of what is no union, where bundles gain nothing.
    void nearestOneByOne(std::span<const Ray> rays, TraceContext& context,
                         std::span<NearestHit> nearest) const;
    /// Leaves, of the hits from `first` on, those that bound the solid, in order of t. Which part they are on
    /// is told by context.partHits from `firstPartHit` on, which is taken away.
    void settle(const Ray& ray, Wanted wanted, TraceContext& context, std::size_t firstPartHit, HitList& hits,
                std::size_t first) const;
    /// How far the ray can be followed from hits that lie together without meeting another.
    struct Room {
        double before, after;
    };
    /// Where surfaces of several parts coincide, rounding decides whether a part holds the hit of another.
    /// When none of the hits would be visible although the solid begins or ends there, they are.
    void findVisible(const Ray& ray, const Room& room, std::span<PartHit> together, const HitList& hits,
                     TraceContext& context) const;
    bool visible(const Hit& hit, std::size_t part, TraceContext& context) const;
    template <class Farthest>
    Selection select(std::size_t part, std::span<const Ray> rays, std::span<const SlabRay> slabs,
                     Farthest farthest) const;

    CsgOperation operation_;
    std::vector<ShapePointer> parts_;
    std::vector<Bounds> partHulls_;   ///< of the surface of each part, as far as others do not cut it off
    std::vector<Bounds> partSolids_;  ///< of what each part contains
    Bounds bounds_;
    Bounds hull_;  ///< boundsWithin() of everywhere
    bool searchesBundles_ = false;
    /// Of unions and merges with many parts: those that answer ray by ray are found by a tree, the rest is
    /// asked one part after another, many rays at a time.
    std::vector<std::size_t> inTree_;
    std::vector<std::size_t> outsideTree_;
    Bvh tree_;
    /// Of intersections and differences of such parts.
    std::optional<ConvexIntersection> convex_;
};

}  // namespace isoscope
