// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/function/patterns/tilings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isoscope {

namespace {

constexpr double root2 = std::numbers::sqrt2;
/// The height of a triangle of unit sides; a third of it is the radius of the circle inside.
constexpr double h = std::numbers::sqrt3 / 2;

/// A polygon of unit sides, of which the first leads from (x, z) in a direction in degrees.
Tile regular(int kind, int sides, double x, double z, double direction) {
    Tile tile{kind, {}, {}};
    for (int k = 0; k < sides; ++k) {
        tile.corners.push_back({x, z});
        const PlanePoint side = polar(1, direction + 360.0 * k / sides);
        x += side[0];
        z += side[1];
    }
    return tile;
}

Tile box(int kind, double left, double low, double right, double high) {
    return {kind, {{left, low}, {right, low}, {right, high}, {left, high}}, {}};
}

/// A triangle that points to +z, by its lower left corner.
Tile upright(int kind, double x, double z) { return regular(kind, 3, x, z, 0); }
/// One that points to -z, by its upper right corner.
Tile hanging(int kind, double x, double z) { return regular(kind, 3, x, z, 180); }
Tile hexagon(int kind, double x, double z) { return regular(kind, 6, x, z, 0); }

/// Four trapezoids around a square, of the kinds at its right, left, lower and upper side.
std::vector<Tile> framed(int square, int right, int left, int low, int high) {
    constexpr double w = root2 / 2;
    return {box(square, w, w, 3 * w, 3 * w),
            {right, {{4 * w, 0}, {4 * w, 4 * w}, {3 * w, 3 * w}, {3 * w, w}}, {}},
            {left, {{0, 0}, {w, w}, {w, 3 * w}, {0, 4 * w}}, {}},
            {low, {{0, 0}, {4 * w, 0}, {3 * w, w}, {w, w}}, {}},
            {high, {{w, 3 * w}, {3 * w, 3 * w}, {4 * w, 4 * w}, {0, 4 * w}}, {}}};
}

/// Hexagons, each amid squares and triangles.
Tiling rhombitrihexagonal(int kinds, const std::array<int, 6>& kind) {
    return {kinds,
            h / 3,
            {1.5 + h, 0.5 + h},
            {1.5 + h, -0.5 - h},
            {box(kind[0], h, -0.5, 1 + h, 0.5), regular(kind[1], 4, 1.5 + h, -0.5 - h, 30),
             regular(kind[2], 4, 1 + 2 * h, 0, 60), regular(kind[3], 3, 1 + h, -0.5, 30),
             regular(kind[4], 3, 0, 0, -30), hexagon(kind[5], 1.5 + 2 * h, -h)}};
}

/// Polygons of twelve sides, each amid hexagons and squares.
Tiling truncatedTrihexagonal(int kinds, const std::array<int, 5>& kind) {
    return {kinds,
            0.5,
            {3 + 2 * h, 0},
            {1.5 + h, 1.5 + 3 * h},
            {hexagon(kind[0], 1 + h, -h), hexagon(kind[0], 2.5 + 2 * h, 0.5),
             box(kind[1], 2.5 + 2 * h, 0.5 + 2 * h, 3.5 + 2 * h, 1.5 + 2 * h),
             regular(kind[2], 4, 0.5 + h, 0, 60), regular(kind[3], 4, 2.5 + h, 0, 30),
             regular(kind[4], 12, 1 + h, h, 0)}};
}

/// Polygons of twelve sides and triangles. At the lowest side and those to the left and right POV-Ray's bevel
/// is wider.
Tiling truncatedHexagonal() {
    Tile dodecagon = regular(2, 12, 0.5 + h, 0, 0);
    dodecagon.bevels.assign(12, h / 3);
    for (const std::size_t side : {0U, 3U, 9U}) dodecagon.bevels[side] = 1.0 / 3;
    return {3,
            h / 3,
            {2 + 2 * h, 0},
            {1 + h, 1.5 + 2 * h},
            {upright(0, 1.5 + 2 * h, 0.5), hanging(1, 2.5 + 2 * h, 1.5 + 2 * h), std::move(dodecagon)}};
}

Tiling snubHexagonal(double mirrored) {
    Tiling tiling{3, h / 3, {2.5, -h * mirrored}, {2, 2 * h * mirrored}, {}};
    const bool plain = mirrored > 0;
    const std::array<PlanePoint, 4> up =
        plain ? std::array<PlanePoint, 4>{{{0, 0}, {1, 0}, {1.5, h}, {2, 0}}}
              : std::array<PlanePoint, 4>{{{1, 0}, {1.5, -h}, {2, -2 * h}, {3.5, -h}}};
    const std::array<PlanePoint, 4> down =
        plain ? std::array<PlanePoint, 4>{{{1.5, h}, {2.5, h}, {3, 2 * h}, {3, 0}}}
              : std::array<PlanePoint, 4>{{{2, 0}, {2.5, -h}, {2.5, h}, {3.5, -h}}};
    for (const PlanePoint& p : up) tiling.tiles.push_back(upright(0, p[0], p[1]));
    for (const PlanePoint& p : down) tiling.tiles.push_back(hanging(1, p[0], p[1]));
    tiling.tiles.push_back(plain ? hexagon(2, 3, 0) : hexagon(2, 2.5, -h));
    return tiling;
}

Tiling cubes() {
    const auto rhomb = [](int kind, PlanePoint a, PlanePoint b, PlanePoint c, PlanePoint d) {
        return Tile{kind, {a, b, c, d}, {}};
    };
    return {3,
            h / 2,
            {1.5, h},
            {1.5, -h},
            {rhomb(0, {0, 0}, {1, 0}, {1.5, h}, {0.5, h}), rhomb(1, {1, 0}, {1.5, -h}, {2, 0}, {1.5, h}),
             rhomb(2, {0, 0}, {0.5, -h}, {1.5, -h}, {1, 0})}};
}

std::vector<Tiling> allTilings() {
    constexpr double octagonal = 1 + root2;
    std::vector<Tiling> all;
    all.push_back({1, 0.5, {1, 0}, {0, 1}, {box(0, 0, 0, 1, 1)}});
    all.push_back({1, h, {1.5, h}, {1.5, -h}, {hexagon(0, 1.5, -h)}});
    all.push_back({2, h / 3, {1, 0}, {0.5, h}, {upright(0, 0, 0), hanging(1, 1.5, h)}});
    all.push_back({1, h / 2, {1, 0}, {0.5, h}, {{0, {{0, 0}, {1, 0}, {1.5, h}, {0.5, h}}, {}}}});
    all.push_back(cubes());
    all.push_back({2, 0.5, {1, 1}, {2, -2}, {box(0, 0, -1, 2, 0), box(1, 2, -2, 3, 0)}});
    all.push_back({2,
                   0.5,
                   {octagonal, 0},
                   {0, octagonal},
                   {regular(0, 4, octagonal / 2, 0.5, 45), regular(1, 8, -0.5, -octagonal / 2, 0)}});
    all.push_back(
        {3, h / 3, {1, 0}, {0.5, 1 + h}, {upright(0, 0, 1), hanging(1, 1.5, 1 + h), box(2, 0, 0, 1, 1)}});
    all.push_back({3, h / 3, {2, 0}, {1, 2 * h}, {upright(0, 1, 0), hanging(1, 2, 2 * h), hexagon(2, 0, 0)}});
    all.push_back({1, 0.5, {1, 0}, {0.5, 1}, {box(0, 0, 0, 1, 1)}});
    all.push_back({3,
                   0.5,
                   {3, 0},
                   {0, 3},
                   {box(0, 1, 1, 2, 2), box(1, 0, 2, 2, 3), box(1, 1, 0, 3, 1), box(2, 0, 0, 1, 2),
                    box(2, 2, 1, 3, 3)}});
    all.push_back({3,
                   0.5,
                   {3, 3},
                   {3, -3},
                   {box(0, 1, -2, 2, -1), box(0, 1, 1, 2, 2), box(1, 1, -1, 3, 0), box(1, 1, 0, 3, 1),
                    box(1, 3, -1, 5, 0), box(1, 3, 0, 5, 1), box(2, 2, 1, 3, 3), box(2, 2, -3, 3, -1),
                    box(2, 3, 1, 4, 3), box(2, 3, -3, 4, -1)}});
    all.push_back({3, root2 / 4, {2 * root2, 0}, {0, 2 * root2}, framed(0, 2, 2, 1, 1)});
    all.push_back({5, root2 / 4, {2 * root2, 0}, {0, 2 * root2}, framed(4, 0, 1, 2, 3)});
    all.push_back({2, 0.5, {2, 1}, {1, -2}, {box(0, 1, -2, 2, -1), box(1, 1, -1, 3, 1)}});
    all.push_back(rhombitrihexagonal(3, {0, 0, 0, 1, 1, 2}));
    all.push_back(rhombitrihexagonal(6, {0, 1, 2, 3, 4, 5}));
    all.push_back({2,
                   0.5,
                   {2, 2},
                   {2, -2},
                   {box(0, 0, -1, 2, 0), box(0, 2, 0, 4, 1), box(1, 1, 0, 2, 2), box(1, 2, -2, 3, 0)}});
    all.push_back(snubHexagonal(1));
    all.push_back(snubHexagonal(-1));
    all.push_back({6,
                   h / 3,
                   {0.5 + h, 0.5 + h},
                   {0.5 + h, -0.5 - h},
                   {regular(0, 3, 0, -0.5, 30), regular(1, 3, 0.5 + h, -h, 60), regular(2, 3, 1 + h, 0, -30),
                    upright(3, h, 0), regular(4, 4, h, 0, 60), regular(5, 4, 0.5, -0.5 - h, 30)}});
    all.push_back(truncatedHexagonal());
    all.push_back(truncatedTrihexagonal(3, {0, 1, 1, 1, 2}));
    all.push_back(truncatedTrihexagonal(5, {0, 1, 2, 3, 4}));
    return all;
}

/// Whether the tile, in the coordinates of the two vectors and moved by whole numbers, has a part of the unit
/// square inside, by separating axes: those of the square and the sides of the tile.
bool reachesIntoUnitSquare(const std::vector<PlanePoint>& corners) {
    constexpr double touching = 1e-9;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const auto [low, high] =
            std::ranges::minmax(corners, {}, [&](const PlanePoint& corner) { return corner[axis]; });
        if (low[axis] >= 1 - touching || high[axis] <= touching) return false;
    }
    double turn = 0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const PlanePoint &a = corners[k], &b = corners[(k + 1) % corners.size()];
        turn += a[0] * b[1] - a[1] * b[0];
    }
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const PlanePoint &a = corners[k], &b = corners[(k + 1) % corners.size()];
        double deepest = -1;
        for (const PlanePoint& p : {PlanePoint{0, 0}, {1, 0}, {0, 1}, {1, 1}}) {
            const double side = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
            deepest = std::max(deepest, turn < 0 ? -side : side);
        }
        if (deepest <= touching) return false;
    }
    return true;
}

}  // namespace

const Tiling& tilingOf(int number) {
    static const std::vector<Tiling> all = allTilings();
    return all[static_cast<std::size_t>(std::clamp(number, 1, tilingCount) - 1)];
}

std::vector<Tile> tilesInCell(const Tiling& tiling) {
    const PlanePoint &a = tiling.across, &b = tiling.along;
    const double area = a[0] * b[1] - a[1] * b[0];
    std::vector<Tile> inside;
    // No tile is longer than three of the vectors.
    constexpr int reach = 4;
    for (const Tile& tile : tiling.tiles)
        for (int i = -reach; i <= reach; ++i)
            for (int j = -reach; j <= reach; ++j) {
                Tile moved = tile;
                std::vector<PlanePoint> corners;
                for (PlanePoint& p : moved.corners) {
                    p = {p[0] + i * a[0] + j * b[0], p[1] + i * a[1] + j * b[1]};
                    corners.push_back(
                        {(p[0] * b[1] - p[1] * b[0]) / area, (a[0] * p[1] - a[1] * p[0]) / area});
                }
                if (reachesIntoUnitSquare(corners)) inside.push_back(std::move(moved));
            }
    return inside;
}

}  // namespace isoscope
