// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/shapes/box_tree.h"
#include "core/shapes/shape.h"

namespace isoscope {

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

    CsgOperation operation() const { return operation_; }
    const std::vector<ShapePointer>& parts() const { return parts_; }

    void intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const override;
    void nearest(std::span<const Ray> rays, TraceContext& context,
                 std::span<NearestHit> nearest) const override;
    void allHits(std::span<const Ray> rays, TraceContext& context, std::span<HitList> hits) const override;
    bool contains(const glm::dvec3& point, TraceContext& context) const override;
    Bounds bounds() const override { return bounds_; }

  private:
    /// The rays that may meet a part before `farthest(index of the ray)`.
    struct Selection {
        std::vector<std::size_t> indices;
        std::vector<Ray> rays;
    };

    /// Whether the tree decides which parts a ray is shown to.
    bool hasTree() const { return !inTree_.empty(); }
    void plantTree();
    /// nearest() by way of the tree, for the parts that are in it.
    void nearestInTree(std::span<const Ray> rays, TraceContext& context, std::span<NearestHit> nearest) const;
    struct Candidate {
        Hit hit;
        std::size_t part;
        bool visible;
    };

    /// Leaves, of the hits from `first` on, those that bound the solid, in order of t; owners[i] is the part
    /// that the hit `first + i` is on.
    void settle(const Ray& ray, TraceContext& context, const std::vector<std::size_t>& owners, HitList& hits,
                std::size_t first) const;
    /// Where surfaces of several parts coincide, rounding decides whether a part holds the hit of another.
    /// When all of the hits are gone although the solid begins or ends there, they come back.
    void restoreSharedWalls(const Ray& ray, TraceContext& context, std::span<Candidate> candidates) const;
    bool visible(const Hit& hit, std::size_t part, TraceContext& context) const;
    template <class Farthest>
    Selection select(std::size_t part, std::span<const Ray> rays, Farthest farthest) const;

    CsgOperation operation_;
    std::vector<ShapePointer> parts_;
    std::vector<Bounds> partBounds_;
    Bounds bounds_;
    /// Of unions and merges with many parts: those that answer ray by ray are found by a tree, the rest is
    /// asked one part after another, many rays at a time.
    std::vector<std::size_t> inTree_;
    std::vector<std::size_t> outsideTree_;
    BoxTree tree_;
};

}  // namespace isoscope
