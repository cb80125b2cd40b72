// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/tables/density_table.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>

#include "core/texture/cubic_weight.h"

namespace isoscope {

namespace {

constexpr std::size_t headerBytes = 6;
constexpr std::uintmax_t fileLimit = 512u << 20;

double bigEndian(const std::string& bytes, std::size_t first, std::size_t count) {
    double value = 0;
    for (std::size_t k = 0; k < count; ++k)
        value = 256 * value + static_cast<unsigned char>(bytes[first + k]);
    return value;
}

}  // namespace

std::shared_ptr<const DensityVolume> readDensityFile(const std::filesystem::path& file,
                                                     std::string& problem) {
    std::error_code failed;
    const std::uintmax_t size = std::filesystem::file_size(file, failed);
    std::ifstream input(file, std::ios::binary);
    if (failed || !input || size > fileLimit) {
        problem = "it cannot be read";
        return nullptr;
    }
    const std::string bytes{std::istreambuf_iterator<char>(input), {}};
    auto volume = std::make_shared<DensityVolume>();
    std::size_t count = bytes.size() < headerBytes ? 0 : 1;
    for (std::size_t k = 0; k < 3 && count > 0; ++k) {
        volume->size[k] = static_cast<int>(bigEndian(bytes, 2 * k, 2));
        count *= static_cast<std::size_t>(volume->size[k]);
    }
    const std::size_t width = count > 0 ? (bytes.size() - headerBytes) / count : 0;
    if (width != 1 && width != 2 && width != 4) {
        problem = "it is no DF3 file";
        return nullptr;
    }
    const double largest = std::pow(256.0, static_cast<double>(width)) - 1;
    volume->samples.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
        volume->samples.push_back(
            static_cast<float>(bigEndian(bytes, headerBytes + i * width, width) / largest));
    return volume;
}

double DensityTable::value(const std::array<double, 3>& point) const {
    for (const double coordinate : point)
        if (!(coordinate >= 0 && coordinate < 1)) return 0;
    switch (interpolation_) {
        case Interpolation::linear: return interpolated(point, 0, 1);
        case Interpolation::cubic: return std::max(0.0, interpolated(point, -1, 2));
        default: return nearest(point);
    }
}

/// What a place along an axis adds to the number of a sample. Beyond its upper sides the volume begins anew,
/// and before the first x; below the others its outermost samples go on.
std::size_t DensityTable::along(std::size_t axis, int index) const {
    const int size = volume_->size[axis];
    if (index < 0) index = axis == 0 ? size + index : 0;
    std::size_t stride = 1;
    for (std::size_t k = 0; k < axis; ++k) stride *= static_cast<std::size_t>(volume_->size[k]);
    return static_cast<std::size_t>(index % size) * stride;
}

double DensityTable::sample(const std::array<int, 3>& index) const {
    return static_cast<double>(
        volume_->samples[along(0, index[0]) + along(1, index[1]) + along(2, index[2])]);
}

double DensityTable::nearest(const std::array<double, 3>& point) const {
    std::array<int, 3> index;
    for (std::size_t k = 0; k < 3; ++k)
        index[k] = std::min(static_cast<int>(point[k] * volume_->size[k]), volume_->size[k] - 1);
    return sample(index);
}

/// Samples lie at whole multiples of 1 / size.
double DensityTable::interpolated(const std::array<double, 3>& point, int first, int last) const {
    std::array<std::array<double, 4>, 3> weights{};
    std::array<std::array<std::size_t, 4>, 3> places{};
    const auto count = static_cast<std::size_t>(last - first + 1);
    for (std::size_t k = 0; k < 3; ++k) {
        const double place = point[k] * volume_->size[k];
        const int base = static_cast<int>(place);
        for (std::size_t i = 0; i < count; ++i) {
            const int step = first + static_cast<int>(i);
            const double away = place - base - step;
            weights[k][i] = first < 0 ? cubicWeight(away) : std::max(0.0, 1 - std::abs(away));
            places[k][i] = along(k, base + step);
        }
    }
    double sum = 0;
    for (std::size_t z = 0; z < count; ++z)
        for (std::size_t y = 0; y < count; ++y)
            for (std::size_t x = 0; x < count; ++x)
                sum += static_cast<double>(volume_->samples[places[0][x] + places[1][y] + places[2][z]]) *
                       weights[0][x] * weights[1][y] * weights[2][z];
    return sum;
}

const SampleBounds& DensityTable::bounds() const {
    std::call_once(bounded_, [&] {
        std::array<SampleAxis, 3> axes;
        for (std::size_t k = 0; k < 3; ++k) axes[k] = {volume_->size[k], 0, k == 0, true};
        const SampleJoin join = interpolation_ == Interpolation::none     ? SampleJoin::none
                                : interpolation_ == Interpolation::linear ? SampleJoin::linear
                                                                          : SampleJoin::cubic;
        bounds_.emplace(axes, join, [this](const std::array<int, 3>& place) { return sample(place); });
    });
    return *bounds_;
}

PointTable::Straightness DensityTable::straightness(const std::array<Interval, 3>& box,
                                                    const std::array<double, 3>& slope,
                                                    const std::array<double, 3>& errors) const {
    std::array<Interval, 3> places;
    std::array<double, 3> slopes, reaches;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto [low, high, undefined] = box[k];
        if (!(low >= 0 && high < 1)) return {};
        const double size = volume_->size[k];
        places[k] = {low * size, high * size, false};
        slopes[k] = slope[k] * size;
        reaches[k] = errors[k] * size;
    }
    // Where what is less than 0 is cut off there is an edge.
    if (interpolation_ == Interpolation::cubic && !(rangeIn(box).low > 0)) return {};
    return bounds().straightness(places, slopes, reaches);
}

Interval DensityTable::rangeIn(const std::array<Interval, 3>& box) const {
    std::array<Interval, 3> places;
    std::array<double, 3> middle;
    bool isWithin = true;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto [low, high, undefined] = box[k];
        if (!(high >= 0 && low < 1)) return Interval::point(0);
        isWithin = isWithin && low >= 0 && high < 1;
        const Interval part{std::max(low, 0.0), std::min(high, std::nextafter(1, 0)), false};
        middle[k] = part.low + (part.high - part.low) / 2;
        places[k] = {part.low * volume_->size[k], part.high * volume_->size[k], false};
    }
    // The spline may fall below 0.
    const double center =
        interpolation_ == Interpolation::cubic ? interpolated(middle, -1, 2) : value(middle);
    const Interval joined = bounds().over(places, center);
    const Interval inside{std::max(joined.low, 0.0), std::max(joined.high, 0.0), false};
    return isWithin ? inside : hull(inside, Interval::point(0));
}

}  // namespace isoscope
