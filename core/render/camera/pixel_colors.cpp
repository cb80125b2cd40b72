// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/camera/pixel_colors.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/render/camera/pixel_colors.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/evaluate/algebra/sleef-inl.h"
#include "core/render/image.h"
#include "core/scene/scene.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {
namespace {

/// One half more than each number, the last few one by one.
void addHalf(const std::int32_t* from, std::size_t count, double* to) {
    const Doubles d;
    const hn::Rebind<std::int32_t, Doubles> integers;
    const auto half = hn::Set(d, 0.5);
    std::size_t k = 0;
    for (; k + hn::Lanes(d) <= count; k += hn::Lanes(d))
        hn::StoreU(hn::Add(hn::PromoteTo(d, hn::LoadU(integers, from + k)), half), d, to + k);
    for (; k < count; ++k) to[k] = from[k] + 0.5;
}

/// x and y take turns.
void moveAll(const std::int32_t* from, std::size_t count, std::int32_t x, std::int32_t y, std::int32_t* to) {
    const hn::ScalableTag<std::int32_t> integers;
    const auto way = hn::OddEven(hn::Set(integers, y), hn::Set(integers, x));
    std::size_t k = 0;
    if constexpr (hn::MaxLanes(integers) > 1)
        for (; k + hn::Lanes(integers) <= count; k += hn::Lanes(integers))
            hn::StoreU(hn::Add(hn::LoadU(integers, from + k), way), integers, to + k);
    for (; k < count; ++k) to[k] = from[k] + (k % 2 == 0 ? x : y);
}

/// Between 0 and 1; NaN becomes 0.
void clipAll(const double* from, std::size_t count, float* to) {
    const Doubles d;
    const hn::Rebind<float, Doubles> floats;
    const auto zero = hn::Zero(d), one = hn::Set(d, 1);
    std::size_t k = 0;
    for (; k + hn::Lanes(d) <= count; k += hn::Lanes(d)) {
        const auto value = hn::LoadU(d, from + k);
        const auto positive = hn::IfThenElseZero(hn::Gt(value, zero), value);
        hn::StoreU(hn::DemoteTo(floats, hn::Min(positive, one)), floats, to + k);
    }
    for (; k < count; ++k) to[k] = static_cast<float>(std::min(std::max(0.0, from[k]), 1.0));
}

/// As decodeChannel() of each number, which must lie between 0 and 1, or its power.
HWY_INLINE Vector linear(Vector value, double gamma) {
    const Doubles d;
    if (gamma != srgbGamma) return sleefPow(value, hn::Set(d, gamma));
    const Vector bent = hn::Div(hn::Add(value, hn::Set(d, 0.055)), hn::Set(d, 1.055));
    const Vector straight = hn::Div(value, hn::Set(d, 12.92));
    return hn::IfThenElse(hn::Le(value, hn::Set(d, 0.04045)), straight, sleefPow(bent, hn::Set(d, 2.4)));
}

/// The last few in a full vector too: a number must not depend on its place.
void linearizeAll(float* values, std::size_t count, double gamma) {
    const Doubles d;
    const hn::Rebind<float, Doubles> floats;
    const std::size_t lanes = hn::Lanes(d);
    for (std::size_t k = 0; k < count; k += lanes) {
        HWY_ALIGN float some[HWY_MAX_BYTES / sizeof(double)] = {};
        const std::size_t here = std::min(lanes, count - k);
        std::copy_n(values + k, here, some);
        hn::Store(hn::DemoteTo(floats, linear(hn::PromoteTo(d, hn::Load(floats, some)), gamma)), floats,
                  some);
        std::copy_n(some, here, values + k);
    }
}

/// Two pixels from the left and two from the right in as few stores as there can be: most of the time of a
/// simple picture goes into them.
HWY_INLINE void writePairs(const float* left, const float* right, float* to) {
#if HWY_TARGET == HWY_SCALAR
    std::copy_n(left, 6, to);
    std::copy_n(right, 6, to + 6);
#else
    const hn::Full128<float> d;
    const hn::Half<decltype(d)> half;
    hn::StoreU(hn::LoadU(d, left), d, to);
    hn::StoreU(hn::Combine(d, hn::LoadU(half, right), hn::LoadU(half, left + 4)), d, to + 4);
    hn::StoreU(hn::LoadU(d, right + 2), d, to + 8);
#endif
}

void writeAllSquares(std::span<const PixelIndex> pixels, const LinearColor* colors, Image& image) {
    constexpr std::size_t side = 4;
    // Where the pairs of a row begin: each square consists of four of 2 x 2.
    constexpr std::size_t left[side] = {0, 2, 8, 10}, right[side] = {4, 6, 12, 14};
    const auto width = static_cast<std::size_t>(image.width);
    for (std::size_t first = 0; first < pixels.size(); first += side * side) {
        const PixelIndex& corner = pixels[first];
        LinearColor* const to =
            &image.pixels[static_cast<std::size_t>(corner.y) * width + static_cast<std::size_t>(corner.x)];
        for (std::size_t y = 0; y < side; ++y)
            writePairs(colors[first + left[y]].data(), colors[first + right[y]].data(), to[y * width].data());
    }
}

}  // namespace
}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(addHalf);
HWY_EXPORT(clipAll);
HWY_EXPORT(linearizeAll);
HWY_EXPORT(moveAll);
HWY_EXPORT(writeAllSquares);

namespace {

static_assert(sizeof(PixelIndex) == 2 * sizeof(std::int32_t));
static_assert(sizeof(SampleBatch::PixelPosition) == 2 * sizeof(double));
static_assert(sizeof(glm::dvec3) == 3 * sizeof(double) && sizeof(LinearColor) == 3 * sizeof(float));

void clip(std::span<const glm::dvec3> colors, std::span<LinearColor> clipped) {
    if (colors.empty()) return;
    HWY_DYNAMIC_DISPATCH(clipAll)(&colors[0].x, 3 * colors.size(), clipped[0].data());
}

LinearColor mean(std::span<const glm::dvec3> samples, double gamma) {
    LinearColor sum{};
    for (const glm::dvec3& sample : samples) {
        LinearColor color;
        clip({&sample, 1}, {&color, 1});
        makeLinear({&color, 1}, gamma);
        for (std::size_t c = 0; c < 3; ++c) sum[c] += color[c];
    }
    for (float& channel : sum) channel /= static_cast<float>(samples.size());
    return sum;
}

}  // namespace

void makeLinear(std::span<LinearColor> colors, double gamma) {
    if (gamma == 1 || (gamma != srgbGamma && !(gamma > 0)) || colors.empty()) return;
    HWY_DYNAMIC_DISPATCH(linearizeAll)(colors[0].data(), 3 * colors.size(), gamma);
}

void placePixels(std::span<const PixelIndex> cells, const PixelIndex& corner, std::span<PixelIndex> pixels) {
    if (cells.empty()) return;
    HWY_DYNAMIC_DISPATCH(moveAll)(&cells[0].x, 2 * cells.size(), corner.x, corner.y, &pixels[0].x);
}

void placeInMiddles(std::span<const PixelIndex> pixels, std::span<SampleBatch::PixelPosition> places) {
    if (pixels.empty()) return;
    HWY_DYNAMIC_DISPATCH(addHalf)(&pixels[0].x, 2 * pixels.size(), &places[0].x);
}

void writeSquares(std::span<const PixelIndex> pixels, std::span<const LinearColor> colors, Image& image) {
    HWY_DYNAMIC_DISPATCH(writeAllSquares)(pixels, colors.data(), image);
}

void makePixels(std::span<const glm::dvec3> samples, double gamma, std::span<LinearColor> pixels) {
    if (samples.size() == pixels.size()) {
        clip(samples, pixels);
        return makeLinear(pixels, gamma);
    }
    const std::size_t each = samples.size() / std::max<std::size_t>(1, pixels.size());
    for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = mean(samples.subspan(i * each, each), gamma);
}

/// std::fill writes number by number; copies of what is filled already go by whole vectors.
void fillPixels(const LinearColor& color, std::span<LinearColor> pixels) {
    std::size_t filled = std::min<std::size_t>(pixels.size(), 32);
    std::fill_n(pixels.begin(), filled, color);
    while (filled < pixels.size()) {
        const std::size_t count = std::min(filled, pixels.size() - filled);
        std::copy_n(pixels.begin(), count, pixels.begin() + static_cast<std::ptrdiff_t>(filled));
        filled += count;
    }
}

}  // namespace isoscope
#endif
