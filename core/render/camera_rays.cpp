// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/camera_rays.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/render/camera_rays.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>

#include "core/shapes/vector_triple-inl.h"

#ifndef ISOSCOPE_RENDER_CAMERA_RAYS_ONCE
#define ISOSCOPE_RENDER_CAMERA_RAYS_ONCE
namespace isoscope {

/// Some samples and their rays, coordinate by coordinate: room for whole vectors.
struct RayBlock {
    static constexpr std::size_t rays = 64;
    using Column = std::array<double, rays>;

    Column x, y;
    std::array<Column, 3> origin, direction;
};

}  // namespace isoscope
#endif

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {
namespace {

HWY_INLINE Triple normalizedOrZero(const Triple& v) {
    const Vector length = hn::Sqrt(dot(v, v));
    const auto usable = hn::And(hn::Gt(length, hn::Zero(Doubles())), finite(length));
    return {hn::IfThenElseZero(usable, hn::Div(v.x, length)),
            hn::IfThenElseZero(usable, hn::Div(v.y, length)),
            hn::IfThenElseZero(usable, hn::Div(v.z, length))};
}

/// Camera::ray for all samples.
void castAll(const Camera& camera, double width, double height, std::size_t count, RayBlock& block) {
    const Triple location = constant(camera.location), direction = constant(camera.direction);
    const Triple right = constant(camera.right), up = constant(camera.up);
    const bool perspective = camera.kind == CameraKind::perspective;
    for (std::size_t k = 0; k < count; k += hn::Lanes(Doubles())) {
        const Vector x = hn::Div(hn::LoadU(Doubles(), &block.x[k]), constant(width));
        const Vector y = hn::Div(hn::LoadU(Doubles(), &block.y[k]), constant(height));
        const Vector u = hn::Sub(x, constant(0.5)), v = hn::Sub(constant(0.5), y);
        const Triple offset = plus(times(right, u), times(up, v));
        store(perspective ? location : plus(location, offset), block.origin, k);
        store(normalizedOrZero(perspective ? plus(direction, offset) : direction), block.direction, k);
    }
}

}  // namespace
}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(castAll);

namespace {

glm::dvec3 at(const std::array<RayBlock::Column, 3>& vectors, std::size_t k) {
    return {vectors[0][k], vectors[1][k], vectors[2][k]};
}

}  // namespace

void CameraRays::append(std::span<const SampleBatch::Place> places, std::size_t first,
                        std::vector<Ray>& rays) const {
    const std::size_t before = rays.size();
    rays.resize(before + places.size());
    RayBlock block{};
    for (std::size_t begun = 0; begun < places.size(); begun += RayBlock::rays) {
        const std::size_t count = std::min(RayBlock::rays, places.size() - begun);
        for (std::size_t k = 0; k < count; ++k)
            block.x[k] = places[begun + k].x, block.y[k] = places[begun + k].y;
        HWY_DYNAMIC_DISPATCH(castAll)(camera_, width_, height_, count, block);
        for (std::size_t k = 0; k < count; ++k) {
            Ray& ray = rays[before + begun + k];
            ray.origin = at(block.origin, k);
            ray.direction = at(block.direction, k);
            ray.sample = static_cast<std::uint32_t>(first + begun + k);
        }
    }
}

RayBundle CameraRays::bundle(std::span<const SampleBatch::Place> places) const {
    SampleBatch::Place low = places.front(), high = low;
    for (const SampleBatch::Place& place : places) {
        low = {std::min(low.x, place.x), std::min(low.y, place.y)};
        high = {std::max(high.x, place.x), std::max(high.y, place.y)};
    }
    return camera_.bundle(low.x / width_ - 0.5, high.x / width_ - 0.5, 0.5 - high.y / height_,
                          0.5 - low.y / height_);
}

}  // namespace isoscope
#endif
