// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/combined/inverse_shape.h"

#include <algorithm>
#include <iterator>
#include <vector>

#include "core/shapes/combined/csg.h"

namespace isoscope {

namespace {

ShapePointer withoutInnerSurfaces(const ShapePointer& shape) {
    using enum Composition::Kind;
    const Composition made = shape->composition();
    if (made.kind == complement) return shape;
    if (made.kind != union_) return withChanged(shape, withoutInnerSurfaces);
    std::vector<ShapePointer> parts;
    for (const ShapePointer& part : made.parts) parts.push_back(withoutInnerSurfaces(part));
    return std::make_shared<Csg>(CsgOperation::merge, std::move(parts));
}

bool hasPatch(const ShapePointer& shape) {
    const Composition made = shape->composition();
    if (made.kind == Composition::Kind::primitive) return shape->isPatch();
    return std::any_of(made.parts.begin(), made.parts.end(), hasPatch);
}

}  // namespace

InverseShape::InverseShape(ShapePointer shape)
    : shape_(std::move(shape)), surface_(withoutInnerSurfaces(shape_)) {}

ShapePointer inverseOf(const ShapePointer& shape) {
    using enum Composition::Kind;
    const Composition made = shape->composition();
    if (made.kind == complement) return made.parts.front();
    if (made.kind == wrapped) return withChanged(shape, inverseOf);
    if (made.kind == primitive || !hasPatch(shape)) return std::make_shared<InverseShape>(shape);
    // A patch has no outside, so that the whole cannot be turned over, but each part.
    std::vector<ShapePointer> parts;
    std::transform(made.parts.begin(), made.parts.end(), std::back_inserter(parts), inverseOf);
    const bool isShared = made.kind == intersection;
    return std::make_shared<Csg>(isShared ? CsgOperation::merge : CsgOperation::intersection,
                                 std::move(parts));
}

void InverseShape::intersect(const Ray& ray, RayInterval interval, TraceContext& context,
                             HitList& hits) const {
    const std::size_t first = hits.size();
    surface_->intersect(ray, interval, context, hits);
    for (std::size_t i = first; i < hits.size(); ++i) hits[i].normal = -hits[i].normal;
}

void InverseShape::nearest(std::span<const Ray> rays, TraceContext& context,
                           std::span<NearestHit> nearest) const {
    std::vector<NearestHit> own(nearest.begin(), nearest.end());
    surface_->nearest(rays, context, own);
    for (std::size_t i = 0; i < own.size(); ++i) {
        if (!own[i].found || (nearest[i].found && !(own[i].hit.t < nearest[i].hit.t))) continue;
        nearest[i] = own[i];
        nearest[i].hit.normal = -nearest[i].hit.normal;
    }
}

void InverseShape::allHits(std::span<const Ray> rays, TraceContext& context, std::span<HitList> hits) const {
    surface_->allHits(rays, context, hits);
    for (HitList& list : hits)
        for (Hit& hit : list) hit.normal = -hit.normal;
}

Composition InverseShape::composition() const {
    return {.kind = Composition::Kind::complement, .parts = {&shape_, 1}};
}

ShapePointer InverseShape::withParts(std::vector<ShapePointer> parts, std::vector<ShapePointer>) const {
    return std::make_shared<InverseShape>(std::move(parts.front()));
}

bool InverseShape::contains(const glm::dvec3& point, TraceContext& context) const {
    return !shape_->isPatch() && !shape_->contains(point, context);
}

}  // namespace isoscope
