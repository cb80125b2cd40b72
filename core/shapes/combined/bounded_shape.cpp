// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/combined/bounded_shape.h"

#include <algorithm>

namespace isoscope {

namespace {

bool isConvex(const Shape& shape) {
    const Composition made = shape.composition();
    if (made.kind == Composition::Kind::wrapped && made.limits.empty()) return isConvex(*made.parts.front());
    return shape.convexSolid() != nullptr;
}

/// Whether the whole box is sure to lie in the shape.
bool holds(const Shape& shape, const Bounds& box) {
    if (!box.finite() || !isConvex(shape)) return false;
    TraceContext context;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 point((corner & 1) != 0 ? box.high.x : box.low.x,
                               (corner & 2) != 0 ? box.high.y : box.low.y,
                               (corner & 4) != 0 ? box.high.z : box.low.z);
        if (!shape.contains(point, context)) return false;
    }
    return true;
}

}  // namespace

ShapePointer boundedBy(ShapePointer shape, const std::vector<ShapePointer>& limits) {
    const Bounds box = shape->bounds();
    std::vector<ShapePointer> effective;
    std::copy_if(limits.begin(), limits.end(), std::back_inserter(effective),
                 [&](const ShapePointer& limit) { return !holds(*limit, box); });
    if (effective.empty()) return shape;
    return std::make_shared<BoundedShape>(std::move(shape), std::move(effective));
}

BoundedShape::BoundedShape(ShapePointer shape, std::vector<ShapePointer> limits)
    : shape_(std::move(shape)), limits_(std::move(limits)), bounds_(shape_->bounds()) {
    for (const ShapePointer& limit : limits_) bounds_ = isoscope::intersect(bounds_, limit->bounds());
}

bool BoundedShape::passes(const Ray& ray, TraceContext& context) const {
    const double nearLimit = context.nearLimit;
    context.nearLimit = 0;
    const bool all = std::all_of(limits_.begin(), limits_.end(), [&](const ShapePointer& limit) {
        NearestHit met;
        limit->nearest({&ray, 1}, context, {&met, 1});
        return met.found || limit->contains(ray.origin, context);
    });
    context.nearLimit = nearLimit;
    return all;
}

void BoundedShape::intersect(const Ray& ray, RayInterval interval, TraceContext& context,
                             HitList& hits) const {
    if (passes(ray, context)) shape_->intersect(ray, interval, context, hits);
}

BoundedShape::Passing BoundedShape::select(std::span<const Ray> rays, TraceContext& context) const {
    Passing passing;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (!passes(rays[i], context)) continue;
        passing.numbers.push_back(i);
        passing.rays.push_back(rays[i]);
    }
    return passing;
}

void BoundedShape::nearest(std::span<const Ray> rays, TraceContext& context,
                           std::span<NearestHit> nearest) const {
    const Passing passing = select(rays, context);
    if (passing.rays.empty()) return;
    std::vector<NearestHit> found;
    for (const std::size_t i : passing.numbers) found.push_back(nearest[i]);
    shape_->nearest(passing.rays, context, found);
    for (std::size_t k = 0; k < found.size(); ++k) nearest[passing.numbers[k]] = found[k];
}

void BoundedShape::allHits(std::span<const Ray> rays, TraceContext& context, std::span<HitList> hits) const {
    for (HitList& list : hits) list.clear();
    const Passing passing = select(rays, context);
    if (passing.rays.empty()) return;
    std::vector<HitList> found(passing.rays.size());
    shape_->allHits(passing.rays, context, found);
    for (std::size_t k = 0; k < found.size(); ++k) hits[passing.numbers[k]] = std::move(found[k]);
}

Composition BoundedShape::composition() const {
    return {.kind = Composition::Kind::wrapped, .parts = {&shape_, 1}, .limits = limits_};
}

ShapePointer BoundedShape::withParts(std::vector<ShapePointer> parts,
                                     std::vector<ShapePointer> limits) const {
    return std::make_shared<BoundedShape>(std::move(parts.front()), std::move(limits));
}

bool BoundedShape::contains(const glm::dvec3& point, TraceContext& context) const {
    return shape_->contains(point, context);
}

}  // namespace isoscope
