// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/combined/placed_shape.h"

#include <limits>

#include "core/shapes/rays/hit_batch.h"
#include "core/shapes/rays/hit_list.h"
#include "core/shapes/rays/nested_memory.h"
#include "core/shapes/rays/placed_lanes.h"
#include "core/shapes/rays/ray_batch.h"
#include "core/shapes/rays/ray_bundle.h"

namespace isoscope {

namespace {

struct MovedRays {
    RayBatch rays;         ///< in the coordinates of the shape
    AlignedColumn before;  ///< t of what was known
};

}  // namespace

PlacedShape::PlacedShape(ShapePointer shape, const Transform& transform, MaterialId material)
    : shape_(std::move(shape)),
      transform_(transform),
      material_(material),
      identity_(transform.identity()),
      bounds_(identity_ ? shape_->bounds() : isoscope::transform(shape_->bounds(), transform.forward())) {
    // One step instead of two. The box above is that of POV-Ray, which boxes the inner box.
    const ShapePointer inner = shape_;
    const Composition made = inner->composition();
    if (made.transform == nullptr || !made.limits.empty()) return;
    shape_ = made.parts.front();
    transform_ = made.transform->then(transform_);
    identity_ = transform_.identity();
    if (made.material != noMaterial) material_ = made.material;
}

void PlacedShape::intersect(const Ray& ray, RayInterval interval, TraceContext& context,
                            HitList& hits) const {
    const std::size_t first = hits.size();
    shape_->intersect(identity_ ? ray : transform_.toObject(ray), interval, context, hits);
    for (std::size_t i = first; i < hits.size(); ++i) place(ray, hits[i]);
}

void PlacedShape::nearest(std::span<const Ray> rays, TraceContext& context,
                          std::span<NearestHit> nearest) const {
    if (identity_ && material_ == noMaterial) return shape_->nearest(rays, context, nearest);
    const double never = std::numeric_limits<double>::infinity();
    std::vector<double> before(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) before[i] = nearest[i].found ? nearest[i].hit.t : never;
    if (identity_)
        shape_->nearest(rays, context, nearest);
    else
        shape_->nearest(toObject(rays), context, nearest);
    for (std::size_t i = 0; i < rays.size(); ++i)
        if (nearest[i].found && nearest[i].hit.t < before[i]) place(rays[i], nearest[i].hit);
}

void PlacedShape::nearestInBatch(const RayBatch& rays, TraceContext& context, HitBatch& hits) const {
    if (identity_ && material_ == noMaterial) return shape_->nearestInBatch(rays, context, hits);
    const NestedMemory<MovedRays> moved(context);
    const double* const t = hits[HitBatch::t];
    moved->before.assign(t, t + hits.size() + LineColumns::padding);
    if (identity_) {
        shape_->nearestInBatch(rays, context, hits);
    } else {
        moveToObject(transform_, rays, moved->rays);
        shape_->nearestInBatch(moved->rays, context, hits);
        if (!context.shadowRay) turnNormals(transform_, moved->before.data(), hits);
    }
    if (material_ != noMaterial)
        for (std::size_t i = 0; i < hits.size(); ++i)
            if (t[i] < moved->before[i] && hits.material(i) == noMaterial) hits.setMaterial(i, material_);
}

void PlacedShape::allHits(std::span<const Ray> rays, TraceContext& context, std::span<HitList> hits) const {
    if (identity_)
        shape_->allHits(rays, context, hits);
    else
        shape_->allHits(toObject(rays), context, hits);
    for (std::size_t i = 0; i < rays.size(); ++i)
        for (Hit& hit : hits[i]) place(rays[i], hit);
}

bool PlacedShape::contains(const glm::dvec3& point, TraceContext& context) const {
    return shape_->contains(identity_ ? point : transform_.inversePoint(point), context);
}

template <class BoundsThere>
Bounds PlacedShape::moved(const Bounds& room, BoundsThere boundsThere) const {
    if (identity_) return boundsThere(room);
    const Bounds there = boundsThere(grown(image(room, transform_.backward())));
    return isoscope::intersect(grown(image(there, transform_.forward())), room);
}

Bounds PlacedShape::boundsWithin(const Bounds& room) const {
    return moved(room, [this](const Bounds& there) { return shape_->boundsWithin(there); });
}

Bounds PlacedShape::complementWithin(const Bounds& room) const {
    return moved(room, [this](const Bounds& there) { return shape_->complementWithin(there); });
}

Composition PlacedShape::composition() const {
    return {.kind = Composition::Kind::wrapped,
            .parts = {&shape_, 1},
            .transform = &transform_,
            .material = material_};
}

ShapePointer PlacedShape::withParts(std::vector<ShapePointer> parts, std::vector<ShapePointer>) const {
    return std::make_shared<PlacedShape>(std::move(parts.front()), transform_, material_);
}

bool PlacedShape::mayBeMet(const RayBundle& rays) const {
    return shape_->mayBeMet(identity_ ? rays : rays.toObject(transform_));
}

std::vector<Ray> PlacedShape::toObject(std::span<const Ray> rays) const {
    std::vector<Ray> moved(rays.begin(), rays.end());
    for (Ray& ray : moved) ray = transform_.toObject(ray);
    return moved;
}

void PlacedShape::place(const Ray& ray, Hit& hit) const {
    if (hit.material == noMaterial) hit.material = material_;
    if (identity_) return;
    hit.point = ray.at(hit.t);
    hit.normal = unitNormal(transform_.normal(hit.normal));
}

}  // namespace isoscope
