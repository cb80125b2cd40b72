// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/combined/inverse_shape.h"

#include <vector>

#include "core/shapes/combined/bounded_shape.h"
#include "core/shapes/combined/clipped_shape.h"
#include "core/shapes/combined/csg.h"
#include "core/shapes/combined/placed_shape.h"
#include "core/shapes/solids/plane.h"

namespace isoscope {

namespace {

ShapePointer withoutInnerSurfaces(const ShapePointer& shape);

ShapePointer mergedParts(const Csg& csg, const ShapePointer& shape) {
    std::vector<ShapePointer> parts;
    bool changed = csg.operation() == CsgOperation::union_;
    for (const ShapePointer& part : csg.parts()) {
        parts.push_back(withoutInnerSurfaces(part));
        changed = changed || parts.back() != part;
    }
    if (!changed) return shape;
    // The parts of a difference are wrapped already: an intersection with them is the same.
    const bool grows = csg.operation() == CsgOperation::union_ || csg.operation() == CsgOperation::merge;
    return std::make_shared<Csg>(grows ? CsgOperation::merge : CsgOperation::intersection, std::move(parts));
}

ShapePointer withoutInnerSurfaces(const ShapePointer& shape) {
    if (const auto* csg = dynamic_cast<const Csg*>(shape.get())) return mergedParts(*csg, shape);
    if (const auto* placed = dynamic_cast<const PlacedShape*>(shape.get())) {
        const ShapePointer inner = withoutInnerSurfaces(placed->shape());
        return inner == placed->shape()
                   ? shape
                   : std::make_shared<PlacedShape>(inner, placed->transform(), placed->material());
    }
    if (const auto* bounded = dynamic_cast<const BoundedShape*>(shape.get())) {
        const ShapePointer inner = withoutInnerSurfaces(bounded->shape());
        return inner == bounded->shape() ? shape : std::make_shared<BoundedShape>(inner, bounded->limits());
    }
    if (const auto* clipped = dynamic_cast<const ClippedShape*>(shape.get())) {
        const ShapePointer inner = withoutInnerSurfaces(clipped->shape());
        return inner == clipped->shape() ? shape : std::make_shared<ClippedShape>(inner, clipped->clips());
    }
    return shape;
}

}  // namespace

InverseShape::InverseShape(ShapePointer shape)
    : shape_(std::move(shape)), surface_(withoutInnerSurfaces(shape_)) {}

ShapePointer inverseOf(const ShapePointer& shape) {
    if (const auto* inverse = dynamic_cast<const InverseShape*>(shape.get())) return inverse->shape();
    if (const auto* placed = dynamic_cast<const PlacedShape*>(shape.get()))
        return std::make_shared<PlacedShape>(inverseOf(placed->shape()), placed->transform(),
                                             placed->material());
    if (const auto* bounded = dynamic_cast<const BoundedShape*>(shape.get()))
        return std::make_shared<BoundedShape>(inverseOf(bounded->shape()), bounded->limits());
    if (const auto* clipped = dynamic_cast<const ClippedShape*>(shape.get()))
        return std::make_shared<ClippedShape>(inverseOf(clipped->shape()), clipped->clips());
    return std::make_shared<InverseShape>(shape);
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

/// Only the other side of a plane is known to be anywhere.
Bounds InverseShape::boundsWithin(const Bounds& room) const {
    if (const auto* plane = dynamic_cast<const Plane*>(shape_.get()))
        return isoscope::intersect(room, Plane(-plane->normal(), -plane->distance()).bounds());
    if (const auto* placed = dynamic_cast<const PlacedShape*>(shape_.get()))
        return PlacedShape(std::make_shared<InverseShape>(placed->shape()), placed->transform())
            .boundsWithin(room);
    return room;
}

bool InverseShape::contains(const glm::dvec3& point, TraceContext& context) const {
    return !shape_->contains(point, context);
}

}  // namespace isoscope
