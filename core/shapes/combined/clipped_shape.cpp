// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/combined/clipped_shape.h"

#include "core/shapes/rays/hit_list.h"

namespace isoscope {

ClippedShape::ClippedShape(ShapePointer shape, std::vector<ShapePointer> clips)
    : shape_(std::move(shape)), clips_(std::move(clips)) {}

void ClippedShape::intersect(const Ray& ray, RayInterval interval, TraceContext& context,
                             HitList& hits) const {
    const std::size_t first = hits.size();
    shape_->intersect(ray, interval, context, hits);
    keepHits(hits, first, [&](const Hit& hit) { return kept(hit.point, context); });
}

void ClippedShape::nearest(std::span<const Ray> rays, TraceContext& context,
                           std::span<NearestHit> nearest) const {
    nearestOfAll(*this, rays, context, nearest);
}

void ClippedShape::allHits(std::span<const Ray> rays, TraceContext& context, std::span<HitList> hits) const {
    shape_->allHits(rays, context, hits);
    for (HitList& list : hits) keepHits(list, 0, [&](const Hit& hit) { return kept(hit.point, context); });
}

bool ClippedShape::contains(const glm::dvec3& point, TraceContext& context) const {
    return kept(point, context) && shape_->contains(point, context);
}

Bounds ClippedShape::bounds() const {
    Bounds result = shape_->bounds();
    for (const ShapePointer& clip : clips_) result = isoscope::intersect(result, clip->bounds());
    return result;
}

Bounds ClippedShape::boundsWithin(const Bounds& room) const {
    Bounds kept = room;
    for (const ShapePointer& clip : clips_) kept = clip->boundsWithin(kept);
    return shape_->boundsWithin(kept);
}

Composition ClippedShape::composition() const {
    return {.kind = Composition::Kind::wrapped, .parts = {&shape_, 1}, .limits = clips_, .limitsCut = true};
}

ShapePointer ClippedShape::withParts(std::vector<ShapePointer> parts,
                                     std::vector<ShapePointer> limits) const {
    return std::make_shared<ClippedShape>(std::move(parts.front()), std::move(limits));
}

bool ClippedShape::kept(const glm::dvec3& point, TraceContext& context) const {
    for (const ShapePointer& clip : clips_)
        if (!clip->contains(point, context)) return false;
    return true;
}

}  // namespace isoscope
