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
/// surface shows with the normal turned over, out of what is left. No parts make an empty shape.
class Csg : public Shape {
  public:
    static constexpr std::size_t treeLimit = 16;

    /// For `difference` the parts after the first are wrapped into InverseShape.
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
