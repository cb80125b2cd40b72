// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/image_map.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/texture/cubic_weight.h"
#include "core/texture/image_place.h"

namespace isoscope {

namespace {

constexpr Color clear{1, 1, 1, 0, 1};

struct Place {
    double u = 0, v = 0;  ///< 0 to 1 over the image, from the left and from below
};

double fraction(double t) { return t - std::floor(t); }

/// A row or column that may lie outside: the edge goes on, or the image begins anew.
int held(int index, int count, bool once) {
    if (once) return std::clamp(index, 0, count - 1);
    const int rest = index % count;
    return rest < 0 ? rest + count : rest;
}

using Samples = std::vector<ImageMap::Sample>;

/// The image with one set of its samples.
struct View {
    const ImageMap& image;
    const Samples& samples;

    Color at(int column, int row) const {
        const ImageMap::Sample& s = samples[static_cast<std::size_t>(held(row, image.height, image.once)) *
                                                static_cast<std::size_t>(image.width) +
                                            static_cast<std::size_t>(held(column, image.width, image.once))];
        return {s[0], s[1], s[2], s[3], s[4]};
    }
};

double linear(double t) { return std::max(0.0, 1 - std::abs(t)); }

/// The samples around, each with its weight: those of rows and columns from `first` to `last` beside the
/// square. Samples lie in the middle of their squares.
template <class Weight>
Color weighted(const View& view, double x, double y, int first, int last, Weight weight) {
    const double left = std::floor(x - 0.5), top = std::floor(y - 0.5);
    const double right = x - 0.5 - left, down = y - 0.5 - top;
    Color sum;
    double total = 0;
    for (int row = first; row <= last; ++row)
        for (int column = first; column <= last; ++column) {
            const double share = weight(right - column, down - row);
            sum = sum + view.at(static_cast<int>(left) + column, static_cast<int>(top) + row) * share;
            total += share;
        }
    return sum * (1 / total);
}

Color interpolated(const View& view, double x, double y) {
    switch (view.image.interpolation) {
        case ImageInterpolation::bicubic:
            return weighted(view, x, y, -1, 2,
                            [](double a, double b) { return cubicWeight(a) * cubicWeight(b); });
        case ImageInterpolation::distance:
            // A sample that is met counts alone.
            return weighted(view, x, y, 0, 1,
                            [](double a, double b) { return 1 / std::max(a * a + b * b, 1e-24); });
        default: return weighted(view, x, y, 0, 1, [](double a, double b) { return linear(a) * linear(b); });
    }
}

/// Where in the image the point lies, each from 0 to 1; nothing where there is no image.
std::optional<Place> placeIn(const ImageMap& image, const glm::dvec3& point) {
    auto [u, v] = imagePlace(image.type, point.x, point.y, point.z);
    if (!std::isfinite(u) || !std::isfinite(v)) return std::nullopt;
    if (image.type != ImageMapType::planar) u = fraction(u);
    const bool inside = u >= 0 && u < 1 && v >= 0 && v < 1;
    if (image.once && !inside) return std::nullopt;
    return Place{fraction(u), fraction(v)};
}

int columnOf(const ImageMap& image, const Place& place) {
    return std::min(static_cast<int>(place.u * image.width), image.width - 1);
}
int rowOf(const ImageMap& image, const Place& place) {
    return image.height - 1 - std::min(static_cast<int>(place.v * image.height), image.height - 1);
}

/// Nothing where there is no image.
std::optional<Color> lookUp(const View& view, const glm::dvec3& point, int right = 0, int below = 0) {
    const ImageMap& image = view.image;
    const std::optional<Place> place = placeIn(image, point);
    if (!place) return std::nullopt;
    if (image.interpolation == ImageInterpolation::none)
        return view.at(columnOf(image, *place) + right, rowOf(image, *place) + below);
    return interpolated(view, place->u * image.width + right, (1 - place->v) * image.height + below);
}

}  // namespace

float darkeningOf(const ImageMap& image, const ImageMap::Sample& sample) {
    return image.darkened && sample[4] < 1 ? 1 - sample[4] : 1;
}

Color imageColor(const ImageMap& image, const glm::dvec3& point) {
    return image.samples ? lookUp({image, *image.samples}, point).value_or(clear) : clear;
}

Color storedColor(const ImageMap& image, const glm::dvec3& point, int right, int below) {
    return image.stored ? lookUp({image, *image.stored}, point, right, below).value_or(Color{}) : Color{};
}

int imageIndex(const ImageMap& image, const glm::dvec3& point) {
    const std::optional<Place> place = placeIn(image, point);
    if (!place) return 0;
    const auto number =
        static_cast<std::size_t>(rowOf(image, *place)) * static_cast<std::size_t>(image.width) +
        static_cast<std::size_t>(columnOf(image, *place));
    if (image.indices) return (*image.indices)[number];
    return image.stored ? static_cast<int>(std::lround(255 * (*image.stored)[number][0])) : 0;
}

}  // namespace isoscope
