// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/placed_shape.h"

#include "core/shapes/hit_list.h"
#include "core/shapes/ray_bundle.h"

namespace isoscope {

PlacedShape::PlacedShape(ShapePointer shape, const Transform& transform, MaterialId material)
    : shape_(std::move(shape)),
      transform_(transform),
      material_(material),
      identity_(transform.identity()),
      bounds_(identity_ ? shape_->bounds() : isoscope::transform(shape_->bounds(), transform.forward())) {}

void PlacedShape::intersect(const Ray& ray, RayInterval interval, TraceContext& context,
                            HitList& hits) const {
    const std::size_t first = hits.size();
    shape_->intersect(identity_ ? ray : transform_.toObject(ray), interval, context, hits);
    for (std::size_t i = first; i < hits.size(); ++i) place(ray, hits[i]);
}

void PlacedShape::nearest(std::span<const Ray> rays, TraceContext& context,
                          std::span<NearestHit> nearest) const {
    const std::vector<Ray> moved = toObject(rays);
    std::vector<NearestHit> own(nearest.begin(), nearest.end());
    shape_->nearest(moved, context, own);
    for (std::size_t i = 0; i < own.size(); ++i) {
        if (!own[i].found || (nearest[i].found && !(own[i].hit.t < nearest[i].hit.t))) continue;
        nearest[i] = own[i];
        place(rays[i], nearest[i].hit);
    }
}

void PlacedShape::allHits(std::span<const Ray> rays, TraceContext& context, std::span<HitList> hits) const {
    shape_->allHits(toObject(rays), context, hits);
    for (std::size_t i = 0; i < rays.size(); ++i)
        for (Hit& hit : hits[i]) place(rays[i], hit);
}

bool PlacedShape::contains(const glm::dvec3& point, TraceContext& context) const {
    return shape_->contains(identity_ ? point : transform_.inverse().point(point), context);
}

bool PlacedShape::mayBeMet(const RayBundle& rays) const {
    return shape_->mayBeMet(identity_ ? rays : rays.toObject(transform_));
}

std::vector<Ray> PlacedShape::toObject(std::span<const Ray> rays) const {
    std::vector<Ray> moved(rays.begin(), rays.end());
    if (!identity_)
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
