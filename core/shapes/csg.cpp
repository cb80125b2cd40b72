// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/csg.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/shapes/hit_list.h"
#include "core/shapes/inverse_shape.h"
#include "core/shapes/isosurface.h"
#include "core/shapes/placed_shape.h"

namespace isoscope {

namespace {

/// A little room for the rounding of the slab test, so that culling never loses a hit on the box itself.
constexpr double slack = 1e-12;

/// Ends the visit of a tree.
constexpr double nothingLeft = -std::numeric_limits<double>::infinity();

bool mayMeet(const Bounds& bounds, const Ray& ray, double farthest) {
    const RayInterval inside = bounds.clip(ray);
    return inside.near <= inside.far + slack * std::abs(inside.far) && inside.near * (1 - slack) <= farthest;
}

/// Whether a shape gains from being asked about many rays at once.
bool likesBundles(const Shape& shape) {
    if (dynamic_cast<const Isosurface*>(&shape)) return true;
    if (const auto* placed = dynamic_cast<const PlacedShape*>(&shape)) return likesBundles(*placed->shape());
    const auto* joined = dynamic_cast<const Csg*>(&shape);
    return joined && std::any_of(joined->parts().begin(), joined->parts().end(),
                                 [](const ShapePointer& part) { return likesBundles(*part); });
}

}  // namespace

Csg::Csg(CsgOperation operation, std::vector<ShapePointer> parts)
    : operation_(operation), parts_(std::move(parts)) {
    if (operation == CsgOperation::difference)
        for (std::size_t i = 1; i < parts_.size(); ++i) parts_[i] = std::make_shared<InverseShape>(parts_[i]);
    for (const ShapePointer& part : parts_) partBounds_.push_back(part->bounds());
    if (parts_.empty()) return;
    const bool grows = operation == CsgOperation::union_ || operation == CsgOperation::merge;
    bounds_ = partBounds_.front();
    for (const Bounds& bounds : partBounds_)
        bounds_ = grows ? unite(bounds_, bounds) : isoscope::intersect(bounds_, bounds);
    if (grows && parts_.size() >= treeLimit) plantTree();
}

void Csg::plantTree() {
    std::vector<Bounds> boxes;
    for (std::size_t part = 0; part < parts_.size(); ++part) {
        if (likesBundles(*parts_[part])) {
            outsideTree_.push_back(part);
            continue;
        }
        inTree_.push_back(part);
        boxes.push_back(partBounds_[part]);
    }
    tree_ = BoxTree(boxes);
}

void Csg::intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const {
    const std::size_t first = hits.size();
    const auto ask = [&](std::size_t part) {
        const std::size_t firstOfPart = hits.size();
        parts_[part]->intersect(ray, interval, context, hits);
        if (operation_ != CsgOperation::union_)
            keepHits(hits, firstOfPart, [&](const Hit& hit) { return visible(hit, part, context); });
    };
    if (hasTree())
        tree_.visit(ray, interval, [&](std::size_t i, double far) {
            ask(inTree_[i]);
            return far;
        });
    const std::size_t others = hasTree() ? outsideTree_.size() : parts_.size();
    for (std::size_t k = 0; k < others; ++k) {
        const std::size_t part = hasTree() ? outsideTree_[k] : k;
        if (mayMeet(partBounds_[part], ray, interval.far)) ask(part);
    }
    sortHits(hits, first);
}

void Csg::nearestInTree(std::span<const Ray> rays, TraceContext& context,
                        std::span<NearestHit> nearest) const {
    HitList hits;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        RayInterval interval;
        interval.near = context.nearLimit;
        if (nearest[i].found) interval.far = nearest[i].hit.t;
        tree_.visit(rays[i], interval, [&](std::size_t k, double far) {
            hits.clear();
            parts_[inTree_[k]]->intersect(rays[i], {interval.near, far}, context, hits);
            if (hits.empty()) return far;
            offer(hits.front(), nearest[i]);
            // Shadow rays need not know what is nearest.
            return context.shadowRay ? nothingLeft : std::min(far, hits.front().t);
        });
    }
}

void Csg::nearest(std::span<const Ray> rays, TraceContext& context, std::span<NearestHit> nearest) const {
    if (operation_ != CsgOperation::union_) return nearestOfAll(*this, rays, context, nearest);
    if (hasTree()) nearestInTree(rays, context, nearest);
    const std::size_t others = hasTree() ? outsideTree_.size() : parts_.size();
    for (std::size_t number = 0; number < others; ++number) {
        const std::size_t part = hasTree() ? outsideTree_[number] : number;
        const auto farthest = [&](std::size_t i) {
            return nearest[i].found ? nearest[i].hit.t : RayInterval().far;
        };
        const Selection chosen = select(part, rays, farthest);
        if (chosen.rays.empty()) continue;
        std::vector<NearestHit> found;
        for (const std::size_t i : chosen.indices) found.push_back(nearest[i]);
        parts_[part]->nearest(chosen.rays, context, found);
        for (std::size_t k = 0; k < found.size(); ++k) nearest[chosen.indices[k]] = found[k];
    }
}

void Csg::allHits(std::span<const Ray> rays, TraceContext& context, std::span<HitList> hits) const {
    for (HitList& list : hits) list.clear();
    if (hasTree() && outsideTree_.empty()) {
        for (std::size_t i = 0; i < rays.size(); ++i) intersect(rays[i], {}, context, hits[i]);
        return;
    }
    for (std::size_t part = 0; part < parts_.size(); ++part) {
        const Selection chosen = select(part, rays, [](std::size_t) { return RayInterval().far; });
        if (chosen.rays.empty()) continue;
        std::vector<HitList> found(chosen.rays.size());
        parts_[part]->allHits(chosen.rays, context, found);
        for (std::size_t k = 0; k < found.size(); ++k)
            for (const Hit& hit : found[k])
                if (operation_ == CsgOperation::union_ || visible(hit, part, context))
                    hits[chosen.indices[k]].push_back(hit);
    }
    for (HitList& list : hits) sortHits(list, 0);
}

template <class Farthest>
Csg::Selection Csg::select(std::size_t part, std::span<const Ray> rays, Farthest farthest) const {
    Selection result;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (!mayMeet(partBounds_[part], rays[i], farthest(i))) continue;
        result.indices.push_back(i);
        result.rays.push_back(rays[i]);
    }
    return result;
}

bool Csg::contains(const glm::dvec3& point, TraceContext& context) const {
    const bool grows = operation_ == CsgOperation::union_ || operation_ == CsgOperation::merge;
    for (std::size_t part = 0; part < parts_.size(); ++part) {
        if (grows && !partBounds_[part].contains(point)) continue;
        if (parts_[part]->contains(point, context) == grows) return grows;
    }
    return !grows && !parts_.empty();
}

bool Csg::visible(const Hit& hit, std::size_t part, TraceContext& context) const {
    const bool wanted = operation_ != CsgOperation::merge;
    for (std::size_t other = 0; other < parts_.size(); ++other) {
        if (other == part || (!wanted && !partBounds_[other].contains(hit.point))) continue;
        if (parts_[other]->contains(hit.point, context) != wanted) return false;
    }
    return true;
}

}  // namespace isoscope
