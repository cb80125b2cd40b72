// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/csg.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/shapes/height_field.h"
#include "core/shapes/hit_list.h"
#include "core/shapes/inverse_shape.h"
#include "core/shapes/isosurface.h"
#include "core/shapes/placed_shape.h"

namespace isoscope {

namespace {

/// A little room for the rounding of the slab test, so that culling never loses a hit on the box itself.
constexpr double slack = 1e-12;

/// Hits nearer together than this, relative to the size of their coordinates, may lie on one surface.
constexpr double sharedWidth = 1e-9;
/// How far to either side of such hits is looked whether they bound the solid, where nothing else is nearer.
constexpr double step = 1e-5;

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

/// Where the inside of a shape may be: that of a height field goes down without end, as in POV-Ray.
Bounds boundsOfInside(const Shape& shape) {
    if (const auto* placed = dynamic_cast<const PlacedShape*>(&shape))
        return dynamic_cast<const HeightField*>(placed->shape().get()) ? Bounds() : shape.bounds();
    return dynamic_cast<const HeightField*>(&shape) ? Bounds() : shape.bounds();
}

}  // namespace

Csg::Csg(CsgOperation operation, std::vector<ShapePointer> parts)
    : operation_(operation), parts_(std::move(parts)) {
    if (operation == CsgOperation::difference)
        for (std::size_t i = 1; i < parts_.size(); ++i) parts_[i] = inverseOf(parts_[i]);
    for (const ShapePointer& part : parts_) partBounds_.push_back(part->bounds());
    if (parts_.empty()) return;
    const bool grows = operation == CsgOperation::union_ || operation == CsgOperation::merge;
    bounds_ = grows ? partBounds_.front() : Bounds();
    for (std::size_t part = 0; part < parts_.size(); ++part)
        bounds_ = grows ? unite(bounds_, partBounds_[part])
                        : isoscope::intersect(bounds_, boundsOfInside(*parts_[part]));
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
    std::vector<std::size_t> owners;
    const auto ask = [&](std::size_t part) {
        parts_[part]->intersect(ray, interval, context, hits);
        if (operation_ != CsgOperation::union_) owners.resize(hits.size() - first, part);
    };
    if (hasTree())
        tree_.visit(ray, interval, [&](std::size_t i, double far) {
            ask(inTree_[i]);
            return far;
        });
    const std::size_t others = hasTree() ? outsideTree_.size() : parts_.size();
    for (std::size_t k = 0; k < others; ++k) {
        const std::size_t number = operation_ == CsgOperation::union_ ? others - 1 - k : k;
        const std::size_t part = hasTree() ? outsideTree_[number] : number;
        if (mayMeet(partBounds_[part], ray, interval.far)) ask(part);
    }
    settle(ray, context, owners, hits, first);
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
    std::vector<std::vector<std::size_t>> owners(rays.size());
    for (std::size_t k = 0; k < parts_.size(); ++k) {
        const std::size_t part = operation_ == CsgOperation::union_ ? parts_.size() - 1 - k : k;
        const Selection chosen = select(part, rays, [](std::size_t) { return RayInterval().far; });
        if (chosen.rays.empty()) continue;
        std::vector<HitList> found(chosen.rays.size());
        parts_[part]->allHits(chosen.rays, context, found);
        for (std::size_t ray = 0; ray < found.size(); ++ray) {
            HitList& list = hits[chosen.indices[ray]];
            list.insert(list.end(), found[ray].begin(), found[ray].end());
            owners[chosen.indices[ray]].resize(list.size(), part);
        }
    }
    for (std::size_t ray = 0; ray < rays.size(); ++ray) settle(rays[ray], context, owners[ray], hits[ray], 0);
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

void Csg::settle(const Ray& ray, TraceContext& context, const std::vector<std::size_t>& owners, HitList& hits,
                 std::size_t first) const {
    if (operation_ == CsgOperation::union_ || hits.size() == first) return sortHits(hits, first);
    std::vector<Candidate> candidates;
    candidates.reserve(hits.size() - first);
    // Of equal hits the last one shows: so POV-Ray decides, each operation anew.
    for (std::size_t i = hits.size(); i-- > first;)
        candidates.push_back({hits[i], owners[i - first], visible(hits[i], owners[i - first], context)});
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.hit.t < b.hit.t; });
    restoreSharedWalls(ray, context, candidates);
    hits.resize(first);
    for (const Candidate& candidate : candidates)
        if (candidate.visible) hits.push_back(candidate.hit);
}

void Csg::restoreSharedWalls(const Ray& ray, TraceContext& context, std::span<Candidate> candidates) const {
    const double speed = glm::length(ray.direction);
    std::size_t end = 0;
    for (std::size_t begin = 0; begin < candidates.size(); begin = end) {
        const double t = candidates[begin].hit.t;
        const glm::dvec3 point = candidates[begin].hit.point;
        const double size = std::max({1.0, std::abs(point.x), std::abs(point.y), std::abs(point.z)}) / speed;
        for (end = begin + 1; end < candidates.size() && candidates[end].hit.t - t <= sharedWidth * size;)
            ++end;
        const std::span<Candidate> together = candidates.subspan(begin, end - begin);
        const auto sameOwner = [&](const Candidate& other) { return other.part == together[0].part; };
        const auto isVisible = [](const Candidate& candidate) { return candidate.visible; };
        if (std::all_of(together.begin(), together.end(), sameOwner) ||
            std::any_of(together.begin(), together.end(), isVisible))
            continue;
        double before = step * size, after = before;
        if (begin > 0) before = std::min(before, (t - candidates[begin - 1].hit.t) / 2);
        if (end < candidates.size())
            after = std::min(after, (candidates[end].hit.t - together.back().hit.t) / 2);
        const bool wasInside = contains(ray.at(t - before), context);
        if (wasInside == contains(ray.at(together.back().hit.t + after), context)) continue;
        for (Candidate& candidate : together)
            candidate.visible = (glm::dot(candidate.hit.normal, ray.direction) > 0) == wasInside;
    }
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
