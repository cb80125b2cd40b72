// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/combined/csg.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/shapes/combined/inverse_shape.h"
#include "core/shapes/rays/hit_list.h"
#include "core/shapes/rays/nested_memory.h"
#include "core/shapes/rays/ray_selection.h"

namespace isoscope {

namespace {

/// Hits nearer together than this, relative to the size of their coordinates, may lie on one surface.
constexpr double sharedWidth = 1e-9;
/// How far to either side of such hits is looked whether they bound the solid, where nothing else is nearer.
constexpr double step = 1e-5;

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Ends the visit of a tree.
constexpr double nothingLeft = -infinity;

/// The hits from `first` on are on that part.
void noteOwner(std::size_t part, std::size_t first, const HitList& hits, std::vector<PartHit>& partHits) {
    for (std::size_t i = first; i < hits.size(); ++i)
        partHits.push_back({hits[i].t, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(part)});
}

}  // namespace

Csg::Csg(CsgOperation operation, std::vector<ShapePointer> parts)
    : operation_(operation), parts_(std::move(parts)) {
    if (operation == CsgOperation::difference)
        for (std::size_t i = 1; i < parts_.size(); ++i) parts_[i] = inverseOf(parts_[i]);
    searchesBundles_ = std::any_of(parts_.begin(), parts_.end(),
                                   [](const ShapePointer& part) { return part->searchesBundles(); });
    if (parts_.empty()) return;
    bounds_ = grows() ? parts_.front()->bounds() : Bounds();
    for (const ShapePointer& part : parts_)
        if (grows())
            bounds_ = unite(bounds_, part->bounds());
        else if (part->boundsCutIntersections())
            bounds_ = isoscope::intersect(bounds_, part->bounds());
    hull_ = parts_.front()->boundsWithin({});
    for (const ShapePointer& part : parts_) {
        const Bounds solid = part->boundsWithin({});
        partSolids_.push_back(solid);
        partHulls_.push_back(isoscope::intersect(solid, part->bounds()));
        hull_ = grows() ? unite(hull_, solid) : isoscope::intersect(hull_, solid);
    }
    if (!grows()) {
        // An endless part may be bounded by the others.
        hull_ = boundsWithin(hull_);
        for (Bounds& hull : partHulls_) hull = isoscope::intersect(hull, hull_);
    }
    if (grows() && parts_.size() >= treeLimit) buildBvh();
    if (!grows()) convex_ = ConvexIntersection::of(parts_);
}

Bounds Csg::boundsWithin(const Bounds& room) const {
    Bounds box = isoscope::intersect(hull_, room);
    if (!grows())
        for (const ShapePointer& part : parts_) box = part->boundsWithin(box);
    return box;
}

void Csg::buildBvh() {
    std::vector<Bounds> boxes;
    for (std::size_t part = 0; part < parts_.size(); ++part) {
        if (parts_[part]->searchesBundles()) {
            outsideTree_.push_back(part);
            continue;
        }
        inTree_.push_back(part);
        boxes.push_back(partHulls_[part]);
    }
    tree_ = Bvh(boxes);
}

void Csg::intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const {
    find(ray, interval, Wanted::all, context, hits);
}

void Csg::find(const Ray& ray, RayInterval interval, Wanted wanted, TraceContext& context,
               HitList& hits) const {
    const SlabRay slabs(ray);
    if (!grows() && !slabs.mayMeet(hull_, interval.far)) return;
    const std::size_t first = hits.size(), firstPartHit = context.partHits.size();
    const auto ask = [&](std::size_t part) {
        const std::size_t before = hits.size();
        parts_[part]->intersect(ray, interval, context, hits);
        if (operation_ != CsgOperation::union_) noteOwner(part, before, hits, context.partHits);
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
        if (slabs.mayMeet(partHulls_[part], interval.far)) ask(part);
    }
    if (hits.size() == first) return;
    settle(ray, wanted, context, firstPartHit, hits, first);
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

void Csg::nearestOneByOne(std::span<const Ray> rays, TraceContext& context,
                          std::span<NearestHit> nearest) const {
    traceOneByOne(rays, context.nearLimit, nearest,
                  [&](const Ray& ray, const RayInterval& interval, HitList& hits) {
                      find(ray, interval, Wanted::nearest, context, hits);
                  });
}

void Csg::nearest(std::span<const Ray> rays, TraceContext& context, std::span<NearestHit> nearest) const {
    if (operation_ != CsgOperation::union_)
        return searchesBundles_ ? nearestOfAll(*this, rays, context, nearest)
                                : nearestOneByOne(rays, context, nearest);
    if (hasTree()) nearestInTree(rays, context, nearest);
    const std::size_t others = hasTree() ? outsideTree_.size() : parts_.size();
    const std::vector<SlabRay> slabs(rays.begin(), rays.end());
    for (std::size_t number = 0; number < others; ++number) {
        const std::size_t part = hasTree() ? outsideTree_[number] : number;
        const auto farthest = [&](std::size_t i) {
            return nearest[i].found ? nearest[i].hit.t : RayInterval().far;
        };
        const Selection chosen = select(part, rays, slabs, farthest);
        if (chosen.rays.empty()) continue;
        std::vector<NearestHit> found;
        for (const std::size_t i : chosen.indices) found.push_back(nearest[i]);
        parts_[part]->nearest(chosen.rays, context, found);
        for (std::size_t k = 0; k < found.size(); ++k) nearest[chosen.indices[k]] = found[k];
    }
}

void Csg::nearestInBatch(const RayBatch& rays, TraceContext& context, HitBatch& hits) const {
    if (operation_ == CsgOperation::union_ && !hasTree()) return nearestOfParts(rays, context, hits);
    if (!convex_) return Shape::nearestInBatch(rays, context, hits);
    std::vector<std::uint32_t> doubtful;
    convex_->nearest(rays, context, hits, doubtful);
    HitList own;
    for (const std::uint32_t i : doubtful) {
        own.clear();
        find(rays.ray(i), {context.nearLimit, hits[HitBatch::t][i]}, Wanted::nearest, context, own);
        hits.offer(i, own);
    }
}

void Csg::nearestOfParts(const RayBatch& rays, TraceContext& context, HitBatch& hits) const {
    if (rays.empty()) return;
    const NestedMemory<RaySelection> asked(context);
    asked->slabs.assign(rays);
    for (std::size_t part = 0; part < parts_.size(); ++part) {
        asked->slabs.findMeeting(partHulls_[part], hits[HitBatch::t], asked->meeting);
        if (asked->meeting.empty()) continue;
        if (asked->meeting.size() == rays.size()) {
            parts_[part]->nearestInBatch(rays, context, hits);
            continue;
        }
        asked->gather(rays, hits);
        parts_[part]->nearestInBatch(asked->rays, context, asked->hits);
        hits.takeNearer(asked->hits, asked->meeting);
    }
}

void Csg::allHits(std::span<const Ray> rays, TraceContext& context, std::span<HitList> hits) const {
    for (HitList& list : hits) list.clear();
    if (!searchesBundles_) {
        for (std::size_t i = 0; i < rays.size(); ++i) intersect(rays[i], {}, context, hits[i]);
        return;
    }
    std::vector<std::vector<PartHit>> partHits(rays.size());
    const std::vector<SlabRay> slabs(rays.begin(), rays.end());
    for (std::size_t k = 0; k < parts_.size(); ++k) {
        const std::size_t part = operation_ == CsgOperation::union_ ? parts_.size() - 1 - k : k;
        const Selection chosen = select(part, rays, slabs, [](std::size_t) { return RayInterval().far; });
        if (chosen.rays.empty()) continue;
        std::vector<HitList> found(chosen.rays.size());
        parts_[part]->allHits(chosen.rays, context, found);
        for (std::size_t ray = 0; ray < found.size(); ++ray) {
            HitList& list = hits[chosen.indices[ray]];
            const std::size_t before = list.size();
            list.insert(list.end(), found[ray].begin(), found[ray].end());
            noteOwner(part, before, list, partHits[chosen.indices[ray]]);
        }
    }
    for (std::size_t ray = 0; ray < rays.size(); ++ray) {
        const std::size_t firstPartHit = context.partHits.size();
        context.partHits.insert(context.partHits.end(), partHits[ray].begin(), partHits[ray].end());
        settle(rays[ray], Wanted::all, context, firstPartHit, hits[ray], 0);
    }
}

template <class Farthest>
Csg::Selection Csg::select(std::size_t part, std::span<const Ray> rays, std::span<const SlabRay> slabs,
                           Farthest farthest) const {
    Selection result;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (!slabs[i].mayMeet(partHulls_[part], farthest(i))) continue;
        result.indices.push_back(i);
        result.rays.push_back(rays[i]);
    }
    return result;
}

bool Csg::contains(const glm::dvec3& point, TraceContext& context) const {
    const bool grows = this->grows();
    for (std::size_t part = 0; part < parts_.size(); ++part) {
        if (grows && !partSolids_[part].contains(point)) continue;
        if (parts_[part]->contains(point, context) == grows) return grows;
    }
    return !grows && !parts_.empty();
}

Composition Csg::composition() const {
    using enum Composition::Kind;
    const bool isUnion = operation_ == CsgOperation::union_;
    // The parts of a difference are inverted already: an intersection with them is the same.
    return {.kind = isUnion ? union_ : grows() ? merge : intersection, .parts = parts_};
}

ShapePointer Csg::withParts(std::vector<ShapePointer> parts, std::vector<ShapePointer>) const {
    return std::make_shared<Csg>(grows() ? operation_ : CsgOperation::intersection, std::move(parts));
}

void Csg::settle(const Ray& ray, Wanted wanted, TraceContext& context, std::size_t firstPartHit,
                 HitList& hits, std::size_t first) const {
    if (operation_ == CsgOperation::union_) return sortHits(hits, first);
    std::vector<PartHit>& all = context.partHits;
    // Of equal hits the last one shows: so POV-Ray decides, each operation anew.
    std::sort(all.begin() + static_cast<std::ptrdiff_t>(firstPartHit), all.end(),
              [](const PartHit& a, const PartHit& b) { return a.t != b.t ? a.t < b.t : a.hit > b.hit; });
    const std::size_t end = hits.size();
    const double speed = glm::length(ray.direction);
    for (std::size_t begin = firstPartHit, next = begin; begin < all.size(); begin = next) {
        const glm::dvec3& point = hits[all[begin].hit].point;
        const double size = std::max({1.0, std::abs(point.x), std::abs(point.y), std::abs(point.z)}) / speed;
        for (next = begin + 1; next < all.size() && all[next].t - all[begin].t <= sharedWidth * size;) ++next;
        const double before = begin > firstPartHit ? all[begin].t - all[begin - 1].t : infinity;
        const double after = next < all.size() ? all[next].t - all[next - 1].t : infinity;
        const Room room{std::min(step * size, before / 2), std::min(step * size, after / 2)};
        findVisible(ray, room, std::span(all).subspan(begin, next - begin), hits, context);
        for (std::size_t k = begin; k < next; ++k)
            if (all[k].visible) hits.push_back(Hit(hits[all[k].hit]));
        if (wanted == Wanted::nearest && hits.size() > end) break;
    }
    all.resize(firstPartHit);
    hits.erase(hits.begin() + static_cast<std::ptrdiff_t>(first),
               hits.begin() + static_cast<std::ptrdiff_t>(end));
}

void Csg::findVisible(const Ray& ray, const Room& room, std::span<PartHit> together, const HitList& hits,
                      TraceContext& context) const {
    bool any = false, shared = false;
    for (PartHit& candidate : together) {
        candidate.visible = visible(hits[candidate.hit], candidate.part, context);
        any |= candidate.visible;
        shared |= candidate.part != together[0].part;
    }
    if (any || !shared) return;
    const bool wasInside = contains(ray.at(together[0].t - room.before), context);
    if (wasInside == contains(ray.at(together.back().t + room.after), context)) return;
    for (PartHit& candidate : together)
        candidate.visible = (glm::dot(hits[candidate.hit].normal, ray.direction) > 0) == wasInside;
}

bool Csg::visible(const Hit& hit, std::size_t part, TraceContext& context) const {
    const bool wanted = operation_ != CsgOperation::merge;
    for (std::size_t other = 0; other < parts_.size(); ++other) {
        if (other == part || (!wanted && !partSolids_[other].contains(hit.point))) continue;
        if (parts_[other]->contains(hit.point, context) != wanted) return false;
    }
    return true;
}

}  // namespace isoscope
