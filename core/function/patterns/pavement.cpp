// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/function/patterns/pavement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "core/function/patterns/pavement_layouts.h"

namespace isoscope {

namespace {

/// The height of a triangle of unit sides.
constexpr double h = std::numbers::sqrt3 / 2;
constexpr double infinite = std::numeric_limits<double>::infinity();

/// A side that leaves a corner: its direction, and the number of the side of which cell it is, as seen from
/// the corner's own cell.
struct Spoke {
    int degrees;
    int i, j, side;
};

constexpr std::array<Spoke, 4> ofSquares{{{0, 0, -1, 1}, {90, -1, 0, 0}, {180, -1, -1, 1}, {270, -1, -1, 0}}};
constexpr std::array<Spoke, 6> ofTriangles{
    {{0, 0, 0, 0}, {60, 0, 0, 1}, {120, -1, 0, 2}, {180, -1, 0, 0}, {240, 0, -1, 1}, {300, 0, -1, 2}}};
/// Hexagons have their right and their left corner.
constexpr std::array<Spoke, 3> ofRight{{{0, 1, -1, 0}, {120, 0, 0, 1}, {240, 0, 0, 2}}};
constexpr std::array<Spoke, 3> ofLeft{{{60, -1, 1, 2}, {180, -1, 0, 0}, {300, -1, 0, 1}}};

/// A remainder that is not negative.
long long remainder(long long value, long long divisor) {
    const long long rest = value % divisor;
    return rest < 0 ? rest + divisor : rest;
}

/// Calls visit(place, i, j, spokes) for the corners of the cell in which a point lies: (i, j) is the cell
/// that they belong to.
template <class Visit>
void visitTriangle(double x, double z, Visit&& visit) {
    const double up = z / h, right = x - up / 2, i = std::floor(right), j = std::floor(up);
    const auto corner = [&](double u, double v) { visit({u + v / 2, v * h}, u, v, ofTriangles); };
    const bool pointsUp = (right - i) + (up - j) < 1;
    corner(i + 1, j);
    corner(i, j + 1);
    pointsUp ? corner(i, j) : corner(i + 1, j + 1);
}
template <class Visit>
void visitSquare(double x, double z, Visit&& visit) {
    for (const double i : {std::floor(x), std::floor(x) + 1})
        for (const double j : {std::floor(z), std::floor(z) + 1}) visit({i, j}, i, j, ofSquares);
}
template <class Visit>
void visitHexagon(double x, double z, Visit&& visit) {
    // The one with the nearest centre.
    double nearest = infinite, i = 0, j = 0;
    PlanePoint center{0, 0};
    for (double u = std::round((x + 0.5) / 1.5) - 1, last = u + 2; u <= last; ++u)
        for (double v = std::round((z - h - u * h) / (2 * h)) - 1, end = v + 2; v <= end; ++v) {
            const PlanePoint there{1.5 * u - 0.5, h + u * h + 2 * h * v};
            const double distance = std::hypot(x - there[0], z - there[1]);
            if (distance >= nearest) continue;
            nearest = distance;
            center = there;
            i = u;
            j = v;
        }
    const auto corner = [&](double dx, double dz, int di, int dj, std::span<const Spoke> spokes) {
        visit({center[0] + dx, center[1] + dz}, i + di, j + dj, spokes);
    };
    corner(1, 0, 0, 0, ofRight);
    corner(-0.5, h, -1, 1, ofRight);
    corner(-0.5, -h, -1, 0, ofRight);
    corner(-1, 0, 0, 0, ofLeft);
    corner(0.5, h, 1, 0, ofLeft);
    corner(0.5, -h, 1, -1, ofLeft);
}

std::span<const PavementLayout> layoutsOf(int sides, int tiles) {
    const std::span<const PavementLayout> all = pavementLayouts();
    const auto isBefore = [&](const PavementLayout& layout) {
        return layout.sides < sides || (layout.sides == sides && layout.tiles < tiles);
    };
    const auto isPart = [&](const PavementLayout& layout) {
        return layout.sides == sides && layout.tiles == tiles;
    };
    const auto first = std::find_if_not(all.begin(), all.end(), isBefore);
    return {first, std::find_if_not(first, all.end(), isPart)};
}

}  // namespace

/// Where cells meet: the sides that leave it are counted from its own cell (i, j).
struct Pavement::Corner {
    PlanePoint place;
    long long i, j;
    std::span<const Spoke> spokes;
};

bool Pavement::isBorder(long long i, long long j, int side) const {
    const long long row = remainder(j, layout_.rows), rounds = (j - row) / layout_.rows;
    const long long column = remainder(i - rounds * layout_.shift, layout_.width);
    const char digit = layout_.borders[static_cast<std::size_t>(row * layout_.width + column)];
    return ((digit - '0') >> side & 1) != 0;
}

double Pavement::depthAt(const Corner& corner, PlanePoint point) const {
    const PlanePoint way = difference(point, corner.place);
    double degrees = std::atan2(way[1], way[0]) * (180 / std::numbers::pi);
    if (degrees < 0) degrees += 360;
    // The next borders on both sides of the point.
    int before = -1, behind = -1, first = -1, last = -1;
    for (const Spoke& spoke : corner.spokes) {
        if (!isBorder(corner.i + spoke.i, corner.j + spoke.j, spoke.side)) continue;
        last = spoke.degrees;
        if (first < 0) first = last;
        if (last <= degrees)
            before = last;
        else if (behind < 0)
            behind = last;
    }
    if (first < 0) return infinite;
    if (before < 0) before = last - 360;
    if (behind < 0) behind = first + 360;
    const double left = cross(polar(1, before), way), right = cross(way, polar(1, behind));
    if (behind - before <= 180) return std::min(left, right);
    // The sharpest corners are blunt.
    const PlanePoint middle = polar(1, (before + behind) / 2);
    const double ahead = behind - before > 270 ? way[0] * middle[0] + way[1] * middle[1] : -infinite;
    return std::max({left, right, ahead});
}

double Pavement::value(const std::array<double, 3>& point) const {
    const double x = point[0], z = point[2];
    constexpr double farthest = 1e9;
    if (!(std::abs(x) <= farthest && std::abs(z) <= farthest)) return 0;
    double depth = infinite;
    const auto visit = [&](PlanePoint place, double i, double j, std::span<const Spoke> spokes) {
        const Corner corner{place, static_cast<long long>(i), static_cast<long long>(j), spokes};
        depth = std::min(depth, depthAt(corner, {x, z}));
    };
    if (layout_.sides == 3)
        visitTriangle(x, z, visit);
    else if (layout_.sides == 4)
        visitSquare(x, z, visit);
    else
        visitHexagon(x, z, visit);
    const double width = layout_.sides == 4 ? 0.5 : h / 3;
    return std::clamp(1 - depth / width, 0.0, 1.0);
}

std::shared_ptr<const Pavement> Pavement::of(const PavementChoice& choice) {
    const PavementChoice possible = nearestPavement(choice);
    const auto layout = static_cast<std::size_t>(possible.layout - 1);
    return std::shared_ptr<const Pavement>(new Pavement(layoutsOf(possible.sides, possible.tiles)[layout]));
}

PavementChoice nearestPavement(const PavementChoice& choice) {
    PavementChoice possible;
    possible.sides = choice.sides <= 3 ? 3 : choice.sides <= 5 ? 4 : 6;
    possible.tiles = std::clamp(choice.tiles, 1, possible.sides == 6 ? 5 : 6);
    const auto layouts = static_cast<int>(layoutsOf(possible.sides, possible.tiles).size());
    possible.layout = std::clamp(choice.layout, 1, layouts);
    return possible;
}

}  // namespace isoscope
