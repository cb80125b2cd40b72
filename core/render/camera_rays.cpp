// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/camera_rays.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/render/camera_rays.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <numeric>

#include "core/shapes/vector_triple-inl.h"

#ifndef ISOSCOPE_RENDER_CAMERA_RAYS_ONCE
#define ISOSCOPE_RENDER_CAMERA_RAYS_ONCE
namespace isoscope {

/// Some samples, coordinate by coordinate: room for whole vectors.
struct SampleBlock {
    static constexpr std::size_t samples = 64;

    std::array<double, samples> x{}, y{};
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

/// Camera::ray for all samples, from ray `first` on.
void castAll(const Camera& camera, double width, double height, const SampleBlock& block, std::size_t count,
             std::size_t first, RayBatch& rays) {
    const std::array<double*, 3> origin{rays[RayBatch::originX], rays[RayBatch::originY],
                                        rays[RayBatch::originZ]};
    const std::array<double*, 3> way{rays[RayBatch::directionX], rays[RayBatch::directionY],
                                     rays[RayBatch::directionZ]};
    const Triple location = constant(camera.location), direction = constant(camera.direction);
    const Triple right = constant(camera.right), up = constant(camera.up);
    const bool perspective = camera.kind == CameraKind::perspective;
    for (std::size_t k = 0; k < count; k += hn::Lanes(Doubles())) {
        const Vector x = hn::Div(hn::LoadU(Doubles(), &block.x[k]), constant(width));
        const Vector y = hn::Div(hn::LoadU(Doubles(), &block.y[k]), constant(height));
        const Vector u = hn::Sub(x, constant(0.5)), v = hn::Sub(constant(0.5), y);
        const Triple offset = plus(times(right, u), times(up, v));
        store(perspective ? location : plus(location, offset), origin, first + k);
        store(normalizedOrZero(perspective ? plus(direction, offset) : direction), way, first + k);
    }
}

}  // namespace
}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(castAll);

void CameraRays::append(std::span<const SampleBatch::Place> places, std::size_t first, RayBatch& rays) const {
    const std::size_t before = rays.size();
    rays.reserve(before + places.size());
    rays.setSize(before + places.size());
    SampleBlock block;
    for (std::size_t begun = 0; begun < places.size(); begun += SampleBlock::samples) {
        const std::size_t count = std::min(SampleBlock::samples, places.size() - begun);
        for (std::size_t k = 0; k < count; ++k)
            block.x[k] = places[begun + k].x, block.y[k] = places[begun + k].y;
        HWY_DYNAMIC_DISPATCH(castAll)(camera_, width_, height_, block, count, before + begun, rays);
        std::uint32_t* const samples = rays.samples() + before + begun;
        std::iota(samples, samples + count, static_cast<std::uint32_t>(first + begun));
    }
}

RayBundle CameraRays::bundle(std::span<const SampleBatch::Place> places) const {
    // Two at a time: the processor need not wait for one comparison with the next.
    const std::size_t middle = places.size() / 2;
    SampleBatch::Place low[2] = {places.back(), places.back()}, high[2] = {places.back(), places.back()};
    for (std::size_t k = 0; k < middle; ++k)
        for (const std::size_t half : {0, 1}) {
            const SampleBatch::Place& place = places[half * middle + k];
            low[half] = {std::min(place.x, low[half].x), std::min(place.y, low[half].y)};
            high[half] = {std::max(place.x, high[half].x), std::max(place.y, high[half].y)};
        }
    const double left = std::min(low[0].x, low[1].x), right = std::max(high[0].x, high[1].x);
    const double top = std::min(low[0].y, low[1].y), bottom = std::max(high[0].y, high[1].y);
    return camera_.bundle(left / width_ - 0.5, right / width_ - 0.5, 0.5 - bottom / height_,
                          0.5 - top / height_);
}

}  // namespace isoscope
#endif
