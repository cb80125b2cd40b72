// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/function/patterns/penrose_tiling.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isoscope {

namespace {

constexpr std::size_t families = 5;
constexpr double shift = 0.8;
/// 1 / Tiling::bevel, measured.
constexpr double steepness = 3.4300885;

struct Direction {
    double x = 0, z = 0;

    double along(double u, double w) const { return x * u + z * w; }
};

const std::array<Direction, families>& directions() {
    static const auto all = [] {
        std::array<Direction, families> made;
        for (std::size_t k = 0; k < families; ++k) {
            const double angle = 2 * std::numbers::pi * static_cast<double>(k) / families;
            made[k] = {std::cos(angle), std::sin(angle)};
        }
        return made;
    }();
    return all;
}

/// A rhomb and how deep a point lies in it, below 0 outside.
struct Place {
    double depth = -1;
    int kind = 0;
};

/// The rhomb where line m of family j crosses line n of family k.
Place placeIn(std::size_t j, double m, std::size_t k, double n, double x, double z) {
    const auto& all = directions();
    const Direction &a = all[j], &b = all[k];
    const double turn = a.x * b.z - a.z * b.x;
    const double u = ((m - shift) * b.z - (n - shift) * a.z) / turn;
    const double w = (a.x * (n - shift) - b.x * (m - shift)) / turn;
    // Its lowest corner counts the lines of each family that lie below.
    double left = x - m * a.x - n * b.x, up = z - m * a.z - n * b.z;
    for (std::size_t other = 0; other < families; ++other) {
        if (other == j || other == k) continue;
        const double count = std::ceil(all[other].along(u, w) + shift);
        left -= count * all[other].x;
        up -= count * all[other].z;
    }
    const double s = (left * b.z - up * b.x) / turn, t = (a.x * up - a.z * left) / turn;
    const double depth = std::min({s, 1 - s, t, 1 - t}) * std::abs(turn);
    // The sine of 72 degrees is 0.95, that of 36 degrees 0.59.
    return {depth, std::abs(turn) > 0.75 ? 0 : 1};
}

}  // namespace

double PenroseTiling::value(const std::array<double, 3>& point) const {
    const double x = point[0], z = point[2];
    constexpr double farthest = 1e9;
    if (!(std::abs(x) <= farthest && std::abs(z) <= farthest)) return 0;
    // A corner is the sum of five directions times counts, each a half from its mean at most, which
    // makes 1.62; the point is no further than 1 from one, and places of the grid are 2/5 of those of the
    // tiling.
    constexpr double scale = 0.4, reach = 1.1;
    const auto& all = directions();
    Place best;
    for (std::size_t j = 0; j + 1 < families; ++j) {
        const double first = all[j].along(x, z) * scale + shift;
        for (std::size_t k = j + 1; k < families; ++k) {
            const double second = all[k].along(x, z) * scale + shift;
            for (double m = std::ceil(first - reach); m <= first + reach; ++m)
                for (double n = std::ceil(second - reach); n <= second + reach; ++n) {
                    const Place here = placeIn(j, m, k, n, x, z);
                    if (here.depth > best.depth) best = here;
                }
        }
    }
    return (best.kind + std::max(0.0, 1 - std::max(best.depth, 0.0) * steepness)) / 2;
}

}  // namespace isoscope
