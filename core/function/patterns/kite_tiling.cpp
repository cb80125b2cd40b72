// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/function/patterns/kite_tiling.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <numbers>

namespace isoscope {

namespace {

constexpr double golden = std::numbers::phi;

double radians(double degrees) { return degrees * (std::numbers::pi / 180); }
/// Above 0 for a point to the left of the way from a to b: twice the area of the triangle.
double turn(PlanePoint a, PlanePoint b, PlanePoint point) {
    return cross(difference(b, a), difference(point, a));
}
/// By the golden ratio, nearer to `a`. Exact at a of 0, where halves of all sizes meet.
PlanePoint divided(PlanePoint a, PlanePoint b) {
    constexpr double near = 1 / golden, far = near * near;
    return {a[0] * near + b[0] * far, a[1] * near + b[1] * far};
}

/// Unit sides one after the other from a corner, the first in a direction, with a turn after each but the
/// last.
PenroseShape walk(int kind, PlanePoint corner, double degrees, std::initializer_list<double> turns) {
    PenroseShape shape{kind, {}};
    for (const double next : turns) {
        shape.corners.push_back(corner);
        corner = sum(corner, polar(1, degrees));
        degrees += next;
    }
    shape.corners.push_back(corner);
    return shape;
}

/// Radii of the circles around a pentagon of unit sides and in it.
const double around = 0.5 / std::sin(radians(36)), within = 0.5 / std::tan(radians(36));
/// From one to its neighbours, and from the centre of a star to its tips.
const double apart = 2 * within;

/// The centre of the neighbour of a pentagon, or the tip of a star.
PlanePoint beside(PlanePoint center, double degrees) { return sum(center, polar(apart, degrees)); }

/// Of kind 0 to 2, given the direction of a corner.
PenroseShape pentagon(int kind, PlanePoint center, double degrees) {
    return walk(kind, sum(center, polar(around, degrees)), degrees + 126, {72, 72, 72, 72});
}
/// Given the direction of a tip.
PenroseShape star(PlanePoint center, double degrees) {
    return walk(3, beside(center, degrees), degrees + 162, {-72, 144, -72, 144, -72, 144, -72, 144, -72});
}
/// From a tip along the axis.
PenroseShape boat(PlanePoint tip, double degrees) {
    return walk(4, tip, degrees - 18, {-72, 144, 36, 36, 144, -72});
}
PenroseShape diamond(PlanePoint tip, double degrees) { return walk(5, tip, degrees - 18, {36, 144, 36}); }

std::vector<PenroseShape> pentagonsInKite(double side) {
    const PlanePoint tip{0, 0}, end{side, 0}, wing = polar(side, 36), middle{side - apart - around, 0};
    return {star(tip, 0),
            star(end, 180),
            pentagon(0, wing, 36),
            pentagon(2, beside(wing, 216), 0),
            pentagon(2, beside(wing, 288), 0),
            pentagon(0, middle, 0),
            pentagon(2, beside(middle, 180), 36),
            pentagon(1, beside(middle, 108), 36),
            pentagon(1, beside(middle, 36), 36),
            pentagon(1, beside(tip, 36), 0),
            boat(polar(middle[0], 36), 216),
            diamond(sum(middle, polar(around, 72)), 72)};
}

std::vector<PenroseShape> pentagonsInDart(double side) {
    const PlanePoint tip{0, 0}, end{side / golden, 0}, wing = polar(side, 36);
    return {pentagon(0, tip, 0),
            pentagon(2, beside(tip, 36), 36),
            pentagon(0, end, 36),
            pentagon(2, beside(end, 72), 0),
            pentagon(1, beside(end, 144), 0),
            star(wing, 36),
            pentagon(1, beside(wing, 216), 36),
            boat(polar(apart + around, 36), 36),
            diamond({around, 0}, 0)};
}

}  // namespace

double PenroseShape::depth(PlanePoint point) const {
    double least = std::numeric_limits<double>::infinity(), joined = -least;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const PlanePoint &a = corners[k], &b = corners[(k + 1) % corners.size()];
        const PlanePoint& next = corners[(k + 2) % corners.size()];
        joined = std::max(joined, turn(a, b, point) / std::hypot(b[0] - a[0], b[1] - a[1]));
        if (turn(a, b, next) < 0) continue;
        least = std::min(least, joined);
        joined = -std::numeric_limits<double>::infinity();
    }
    return least;
}

/// Half of a kite has angles of 36 degrees at its tip and 72 at its wing and its end, half of a dart 36 at
/// its tip and its wing and 108 at its end. From the tip to the end is the axis of both.
struct KiteTiling::HalfTile {
    bool isKite = true;
    PlanePoint tip{}, wing{}, end{};

    /// The part of it in which a point lies, one step finer.
    HalfTile partAt(PlanePoint point) const {
        const auto isBeside = [&](PlanePoint a, PlanePoint b, PlanePoint other) {
            return (turn(a, b, point) >= 0) == (turn(a, b, other) >= 0);
        };
        if (isKite) {
            const PlanePoint side = divided(tip, wing), axis = divided(end, tip);
            if (isBeside(wing, axis, end)) return {true, wing, end, axis};
            if (isBeside(side, axis, wing)) return {true, wing, side, axis};
            return {false, tip, axis, side};
        }
        const PlanePoint side = divided(wing, tip);
        if (isBeside(side, end, tip)) return {true, tip, side, end};
        return {false, wing, end, side};
    }

    /// The point as it lies to the tip, with the axis as +x and the wing above.
    PlanePoint place(PlanePoint point) const {
        const PlanePoint axis = difference(end, tip), way = difference(point, tip);
        const double length = std::hypot(axis[0], axis[1]), across = cross(axis, way) / length;
        return {(axis[0] * way[0] + axis[1] * way[1]) / length, turn(tip, end, wing) < 0 ? -across : across};
    }
};

KiteTiling::KiteTiling(Tiles tiles) {
    if (tiles == Tiles::pentagons) {
        kinds_ = 6;
        steepness_ = 3.4300885;
        unit_ = around;
        finest_ = 4;
        turn_ = 1;
        const double side = unit_ * std::pow(golden, finest_);
        inKite_ = pentagonsInKite(side);
        inDart_ = pentagonsInDart(side);
    } else {
        kinds_ = 2;
        steepness_ = 4.46;
        unit_ = 1;
        finest_ = turn_ = 0;
        inKite_ = {{0, {{0, 0}, polar(1, -36), {1, 0}, polar(1, 36)}}};
        inDart_ = {{1, {{0, 0}, polar(1, -36), {1 / golden, 0}, polar(1, 36)}}};
    }
}

KiteTiling::HalfTile KiteTiling::halfTileAt(PlanePoint point) const {
    // The nearest places outside five kites are 0.81 of their long sides away.
    const double distance = std::hypot(point[0], point[1]);
    int power = turn_;
    double side = unit_ * std::pow(golden, power);
    for (; power < finest_ || 0.75 * side < distance; power += 4) side *= std::pow(golden, 4);
    const double degrees = std::atan2(point[1], point[0]) / radians(1), axis = 72 * std::round(degrees / 72);
    HalfTile half{true, {0, 0}, polar(side, axis + (degrees < axis ? -36 : 36)), polar(side, axis)};
    for (; power > finest_; --power) half = half.partAt(point);
    return half;
}

double KiteTiling::value(const std::array<double, 3>& point) const {
    constexpr double farthest = 1e9;
    const PlanePoint here{point[0], point[2]};
    if (!(std::abs(here[0]) <= farthest && std::abs(here[1]) <= farthest)) return 0;
    const HalfTile half = halfTileAt(here);
    const PlanePoint place = half.place(here);
    double deepest = -std::numeric_limits<double>::infinity();
    int kind = 0;
    for (const PenroseShape& shape : half.isKite ? inKite_ : inDart_) {
        const double depth = shape.depth(place);
        if (depth <= deepest) continue;
        deepest = depth;
        kind = shape.kind;
    }
    return (kind + std::max(0.0, 1 - std::max(deepest, 0.0) * steepness_)) / kinds_;
}

}  // namespace isoscope
