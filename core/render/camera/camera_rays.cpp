// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/camera/camera_rays.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/render/camera/camera_rays.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>

#include "core/evaluate/point_evaluator.h"
#include "core/render/effect_description.h"
#include "core/render/render_request.h"
#include "core/scene/camera_lens.h"
#include "core/scene/camera_projection.h"
#include "core/shapes/patches/vector_triple-inl.h"

#ifndef ISOSCOPE_RENDER_CAMERA_RAYS_ONCE
#define ISOSCOPE_RENDER_CAMERA_RAYS_ONCE
namespace isoscope {

/// So many samples are whole vectors for any instruction set.
constexpr std::size_t sampleBlock = 64;

}  // namespace isoscope
#endif

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {
namespace {

HWY_INLINE Triple normalizedOrZero(const Triple& v) {
    const Vector length = hn::Sqrt(dot(v, v));
    const auto usable = hn::And(hn::Gt(length, hn::Zero(Doubles())), finite(length));
    const Triple unit = times(v, hn::Div(constant(1), length));
    return {hn::IfThenElseZero(usable, unit.x), hn::IfThenElseZero(usable, unit.y),
            hn::IfThenElseZero(usable, unit.z)};
}

/// Camera::ray for all samples (x, y, x, y, ...; whole vectors are read), from ray `first` on.
void castAll(const Camera& camera, double width, double height, const double* places, std::size_t count,
             std::size_t first, RayBatch& rays) {
    const std::array<double*, 3> origin{rays[RayBatch::originX], rays[RayBatch::originY],
                                        rays[RayBatch::originZ]};
    const std::array<double*, 3> way{rays[RayBatch::directionX], rays[RayBatch::directionY],
                                     rays[RayBatch::directionZ]};
    const Triple location = constant(camera.location), direction = constant(camera.direction);
    const Triple right = constant(camera.right), up = constant(camera.up);
    const bool perspective = camera.kind == CameraKind::perspective;
    for (std::size_t k = 0; k < count; k += hn::Lanes(Doubles())) {
        Vector x, y;
        hn::LoadInterleaved2(Doubles(), places + 2 * k, x, y);
        x = hn::Div(x, constant(width));
        y = hn::Div(y, constant(height));
        const Vector u = hn::Sub(x, constant(0.5)), v = hn::Sub(constant(0.5), y);
        const Triple offset = plus(times(right, u), times(up, v));
        store(perspective ? location : plus(location, offset), origin, first + k);
        store(normalizedOrZero(perspective ? plus(direction, offset) : direction), way, first + k);
    }
}

/// std::iota for whole vectors.
void countAll(std::uint32_t first, std::size_t count, std::uint32_t* numbers) {
    const hn::ScalableTag<std::uint32_t> d;
    auto some = hn::Iota(d, first);
    const auto more = hn::Set(d, static_cast<std::uint32_t>(hn::Lanes(d)));
    for (std::size_t k = 0; k < count; k += hn::Lanes(d), some = hn::Add(some, more))
        hn::StoreU(some, d, numbers + k);
}

/// Widens `extent` to hold `count` samples from `places` on, given as x, y, x, y, ...
void widenAll(const double* places, std::size_t count, SampleBatch::Extent& extent) {
    const hn::CappedTag<double, 8> d;
    const std::size_t numbers = 2 * count;
    std::size_t k = 0;
    if constexpr (hn::MaxLanes(d) >= 2) {
        double lows[hn::MaxLanes(d)], highs[hn::MaxLanes(d)];
        auto low = hn::Set(d, std::numeric_limits<double>::infinity()), high = hn::Neg(low);
        for (; k + hn::Lanes(d) <= numbers; k += hn::Lanes(d)) {
            const auto some = hn::LoadU(d, places + k);
            low = hn::Min(low, some);
            high = hn::Max(high, some);
        }
        hn::StoreU(low, d, lows);
        hn::StoreU(high, d, highs);
        for (std::size_t i = 0; i + 1 < hn::Lanes(d); i += 2) {
            extent.low = {std::min(extent.low.x, lows[i]), std::min(extent.low.y, lows[i + 1])};
            extent.high = {std::max(extent.high.x, highs[i]), std::max(extent.high.y, highs[i + 1])};
        }
    }
    for (; k < numbers; k += 2) {
        extent.low = {std::min(extent.low.x, places[k]), std::min(extent.low.y, places[k + 1])};
        extent.high = {std::max(extent.high.x, places[k]), std::max(extent.high.y, places[k + 1])};
    }
}

}  // namespace
}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(castAll);
HWY_EXPORT(countAll);
HWY_EXPORT(widenAll);

void CameraRays::append(std::span<const SampleBatch::PixelPosition> places, std::size_t first,
                        RayBatch& rays) const {
    if (!camera_.flat() || camera_.normalTape) return appendCurved(places, first, rays);
    const std::size_t before = rays.size();
    rays.reserve(before + places.size());
    rays.setSize(before + places.size());
    const std::size_t whole = places.size() / sampleBlock * sampleBlock;
    if (whole > 0) {
        HWY_DYNAMIC_DISPATCH(castAll)(camera_, width_, height_, &places[0].x, whole, before, rays);
        HWY_DYNAMIC_DISPATCH(countAll)(static_cast<std::uint32_t>(first), whole, rays.samples() + before);
    }
    if (whole < places.size()) {
        std::array<SampleBatch::PixelPosition, sampleBlock> rest{};
        std::copy(places.begin() + static_cast<std::ptrdiff_t>(whole), places.end(), rest.begin());
        HWY_DYNAMIC_DISPATCH(castAll)
        (camera_, width_, height_, &rest[0].x, places.size() - whole, before + whole, rays);
        std::uint32_t* const samples = rays.samples() + before;
        std::iota(samples + whole, samples + places.size(), static_cast<std::uint32_t>(first + whole));
    }
}

void CameraRays::appendCurved(std::span<const SampleBatch::PixelPosition> places, std::size_t first,
                              RayBatch& rays) const {
    const std::size_t before = rays.size();
    rays.reserve(before + places.size());
    rays.setSize(before + places.size());
    for (std::size_t k = 0; k < places.size(); ++k) {
        Ray ray = camera_.ray(places[k].x / width_ - 0.5, 0.5 - places[k].y / height_);
        ray.sample = static_cast<std::uint32_t>(first + k);
        rays.set(before + k, ray);
    }
    if (camera_.normalTape) bend(places, before, rays);
}

/// The rays count as normals of a surface through normalPlace(), as in POV-Ray 3.7 (measured).
void CameraRays::bend(std::span<const SampleBatch::PixelPosition> places, std::size_t first,
                      RayBatch& rays) const {
    std::array<std::vector<double>, 6> columns;
    for (std::size_t k = 0; k < places.size(); ++k) {
        const glm::dvec3 way = rays.ray(first + k).direction;
        const glm::dvec2 place =
            normalPlace(camera_, places[k].x / width_ - 0.5, 0.5 - places[k].y / height_);
        const std::array<double, 6> arguments{place.x, place.y, 0, way.x, way.y, way.z};
        for (std::size_t c = 0; c < columns.size(); ++c) columns[c].push_back(arguments[c]);
    }
    std::array<const double*, 6> arguments;
    std::transform(columns.begin(), columns.end(), arguments.begin(),
                   [](const std::vector<double>& column) { return column.data(); });
    std::array<std::vector<double>, 3> bent;
    std::array<double*, 3> results;
    for (std::size_t c = 0; c < bent.size(); ++c) {
        bent[c].resize(places.size());
        results[c] = bent[c].data();
    }
    PointEvaluator(camera_.normalTape, {}).evaluateAll(arguments, places.size(), results);
    for (std::size_t k = 0; k < places.size(); ++k) {
        Ray ray = rays.ray(first + k);
        const glm::dvec3 way(bent[0][k], bent[1][k], bent[2][k]);
        const double length = glm::length(way);
        if (ray.direction == glm::dvec3(0) || !(length > 0) || !std::isfinite(length)) continue;
        ray.direction = way / length;
        rays.set(first + k, ray);
    }
}

void CameraRays::spread(std::span<const glm::dvec2> lens, RayBatch& rays) const {
    if (lens.empty()) return;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Ray ray = rays.ray(i);
        rays.set(i, throughLens(camera_, ray, lens[ray.sample]));
    }
}

void CameraRays::dropBlind(RayBatch& rays) const {
    if (camera_.flat()) return;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Ray ray = rays.ray(i);
        if (ray.direction != glm::dvec3(0)) rays.set(kept++, ray);
    }
    rays.setSize(kept);
}

SampleBatch::Extent CameraRays::extent(std::span<const SampleBatch::PixelPosition> places) {
    SampleBatch::Extent extent{places.front(), places.front()};
    HWY_DYNAMIC_DISPATCH(widenAll)(&places[0].x, places.size(), extent);
    return extent;
}

RayBundle CameraRays::bundle(const SampleBatch::Extent& extent) const {
    return camera_.bundle(extent.low.x / width_ - 0.5, extent.high.x / width_ - 0.5,
                          0.5 - extent.high.y / height_, 0.5 - extent.low.y / height_);
}

namespace {

EffectReason reasonFor(const Scene& scene) {
    if (!scene.camera.normalTape) return {false, "the camera has no normal"};
    return {true, "the camera has a normal that bends its rays"};
}

void takeOut(RenderRequest& request) { request.camera.normalTape = nullptr; }

}  // namespace

const EffectDescription effects::cameraNormal{
    .name = "camera normal", .reasonFor = reasonFor, .takeOut = takeOut};

}  // namespace isoscope
#endif
