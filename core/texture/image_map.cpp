// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/image_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace isoscope {

namespace {

constexpr Color clear{0, 0, 0, 0, 1};

struct Place {
    double u = 0, v = 0;  ///< 0 to 1 over the image, from the left and from below
};

double fraction(double t) { return t - std::floor(t); }

Place placeOf(ImageMapType type, const glm::dvec3& p) {
    using std::numbers::pi;
    if (type == ImageMapType::planar) return {p.x, p.y};
    const double around = std::hypot(p.x, p.z);
    const double u = around > 0 ? fraction(std::atan2(p.z, p.x) / (2 * pi)) : 0;
    if (type == ImageMapType::cylindrical) return {u, p.y};
    if (type == ImageMapType::torus) return {u, 0.5 + std::atan2(p.y, around - 1) / (2 * pi)};
    return {u, 0.5 + std::atan2(p.y, around) / pi};
}

/// A row or column that may lie outside: the edge goes on, or the image begins anew.
int held(int index, int count, bool once) {
    if (once) return std::clamp(index, 0, count - 1);
    return index < 0 ? index + count : index >= count ? index - count : index;
}

const ImageMap::Sample& sampleAt(const ImageMap& image, int column, int row) {
    return (*image.samples)[static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) +
                            static_cast<std::size_t>(column)];
}

Color colorOf(const ImageMap::Sample& s) { return {s[0], s[1], s[2], s[3], s[4]}; }

/// Samples lie in the middle of their squares.
Color interpolated(const ImageMap& image, double x, double y) {
    const double left = std::floor(x - 0.5), top = std::floor(y - 0.5);
    const double right = x - 0.5 - left, down = y - 0.5 - top;
    Color sum;
    for (int row = 0; row < 2; ++row)
        for (int column = 0; column < 2; ++column) {
            const int i = held(static_cast<int>(left) + column, image.width, image.once);
            const int j = held(static_cast<int>(top) + row, image.height, image.once);
            const double weight = (column ? right : 1 - right) * (row ? down : 1 - down);
            sum = sum + colorOf(sampleAt(image, i, j)) * weight;
        }
    return sum;
}

}  // namespace

Color imageColor(const ImageMap& image, const glm::dvec3& point) {
    Place place = placeOf(image.type, point);
    if (!std::isfinite(place.u) || !std::isfinite(place.v) || !image.samples) return clear;
    const bool inside = place.u >= 0 && place.u < 1 && place.v >= 0 && place.v < 1;
    if (image.once && !inside) return clear;
    place = {fraction(place.u), fraction(place.v)};
    const double x = place.u * image.width, y = (1 - place.v) * image.height;
    if (image.interpolation == ImageInterpolation::bilinear) return interpolated(image, x, y);
    const int column = std::min(static_cast<int>(x), image.width - 1);
    const int row = image.height - 1 - std::min(static_cast<int>(place.v * image.height), image.height - 1);
    return colorOf(sampleAt(image, column, row));
}

}  // namespace isoscope
