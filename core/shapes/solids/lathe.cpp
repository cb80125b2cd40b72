// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/solids/lathe.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/shapes/combined/turned_place.h"
#include "core/shapes/rays/hit_list.h"

namespace isoscope {

namespace {

/// Rays flatter than this are met height by height: the polynomial of degree 6 would have double roots.
constexpr double levelClimb = 1e-6;

/// a s^2 + b s + c = value
RootSequence whereRadius(double a, double b, double c, double value) {
    RootSequence roots;
    realRoots(std::array<double, 3>{a, b, c - value}, -1e12, 1e12, roots);
    return roots;
}

}  // namespace

Lathe::Lathe(std::vector<CurvePiece> curve, RootChoice choice) : outline_(std::move(curve)), choice_(choice) {
    low_ = outline_.low().y;
    high_ = outline_.high().y;
    for (const CurvePiece& piece : outline_.pieces()) {
        glm::dvec2 low, high;
        piece.range(low, high);
        extents_.push_back({low.y, high.y, std::max(std::abs(low.x), std::abs(high.x))});
        radius_ = std::max(radius_, extents_.back().radius);
        hollow_ = std::min(hollow_, std::max(low.x, 0.0));
    }
}

void Lathe::intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const {
    ++context.rays;
    const double middle = (low_ + high_) / 2;
    const CenteredRay line(ray, {0, middle, 0});
    if (!line.usable) return;
    const glm::dvec3 &o = line.origin, &d = line.direction;
    const Profile profile{o.y + middle, d.y, d.x * d.x + d.z * d.z, 2 * (o.x * d.x + o.z * d.z),
                          o.x * o.x + o.z * o.z};
    // The least distance of the ray from the axis.
    const double nearest = profile.a > 0 ? profile.c - profile.b * profile.b / (4 * profile.a) : profile.c;
    const std::size_t first = hits.size();
    std::vector<Place> places;
    for (std::size_t i = 0; i < extents_.size(); ++i) {
        const Extent& extent = extents_[i];
        if (nearest > extent.radius * extent.radius * (1 + 1e-9)) continue;
        const CurvePiece& piece = outline_.pieces()[i];
        places.clear();
        meetPiece(piece, profile, places);
        for (const Place& place : places) {
            const double t = line.toRay(place.s);
            if (!(interval.near <= t && t <= interval.far)) continue;
            const glm::dvec3 at = line.at(place.s);
            const glm::dvec2 slope = piece.slope(place.u);
            const double radius = std::hypot(at.x, at.z);
            // A piece on the far side of the axis is seen as its mirror image.
            const double side = piece.at(place.u).x < 0 ? -1 : 1;
            glm::dvec3 normal(0, 1, 0);
            if (radius > 0)
                normal = unitNormal(glm::dvec3(at.x, 0, at.z) * (slope.y * side / radius) -
                                    glm::dvec3(0, slope.x, 0));
            hits.push_back({t, ray.at(t), normal});
        }
    }
    sortHits(hits, first);
}

void Lathe::meetPiece(const CurvePiece& piece, const Profile& ray, std::vector<Place>& places) const {
    if (std::abs(ray.climb) < levelClimb)
        meetLevel(piece, ray, places);
    else
        meetSlanted(piece, ray, places);
}

void Lathe::meetSlanted(const CurvePiece& piece, const Profile& ray, std::vector<Place>& places) const {
    // climb^2 r(u)^2 = a h^2 + b climb h + c climb^2 with h = y(u) - height, s = h / climb
    std::array<double, 4> r{}, h{};
    for (std::size_t k = 0; k < 4; ++k) {
        r[k] = piece.c[k].x * ray.climb;
        h[k] = piece.c[k].y - (k == 0 ? ray.height : 0);
    }
    std::array<double, 7> polynomial{};
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) polynomial[6 - i - j] += r[i] * r[j] - ray.a * h[i] * h[j];
        polynomial[6 - i] -= ray.b * ray.climb * h[i];
    }
    polynomial[6] -= ray.c * ray.climb * ray.climb;
    RootSequence roots;
    const std::span<const double> terms(polynomial);
    chosenRoots(choice_, terms.last(static_cast<std::size_t>(2 * piece.degree) + 1), 0, 1, roots);
    for (const double u : roots) {
        const glm::dvec2 at = piece.at(u);
        double s = (at.y - ray.height) / ray.climb;
        if (std::abs(ray.climb) < 0.05) {
            // The height says little about a flat ray: of the two places with the right radius, the nearer
            // one.
            double best = s, distance = INFINITY;
            for (const double place : whereRadius(ray.a, ray.b, ray.c, at.x * at.x))
                if (std::abs(place - s) < distance) distance = std::abs(place - s), best = place;
            s = best;
        }
        places.push_back({u, s});
    }
}

void Lathe::meetLevel(const CurvePiece& piece, const Profile& ray, std::vector<Place>& places) const {
    RootSequence heights;
    piece.meet({0, 1}, ray.height, heights);
    for (double u : heights) {
        const double radius = piece.at(u).x;
        for (const double s : whereRadius(ray.a, ray.b, ray.c, radius * radius)) {
            // One of Newton's steps for the little climb there is.
            const double slope = piece.slope(u).y;
            if (slope != 0) u = std::clamp(u + s * ray.climb / slope, 0.0, 1.0);
            places.push_back({u, s});
        }
    }
}

bool Lathe::contains(const glm::dvec3& point, TraceContext&) const {
    if (!(point.y >= low_ && point.y <= high_)) return false;
    const double radius = std::hypot(point.x, point.z);
    return radius >= hollow_ && outline_.covers({radius, point.y});
}

/// v counts the pieces of the curve.
std::optional<glm::dvec2> Lathe::surfacePlace(const glm::dvec3& point) const {
    const glm::dvec2 place(std::hypot(point.x, point.z), point.y);
    const std::vector<CurvePiece>& pieces = outline_.pieces();
    double v = 0, nearest = std::numeric_limits<double>::infinity();
    RootSequence roots;
    for (std::size_t k = 0; k < pieces.size(); ++k)
        for (const glm::dvec2 axis : {glm::dvec2(0, 1), glm::dvec2(1, 0)}) {
            pieces[k].meet(axis, glm::dot(axis, place), roots);
            for (const double u : roots) {
                const double away = glm::distance(pieces[k].at(u), place);
                if (away >= nearest) continue;
                nearest = away;
                v = (static_cast<double>(k) + u) / static_cast<double>(pieces.size());
            }
        }
    return glm::dvec2(turnedPlace(point.x, point.z), v);
}

}  // namespace isoscope
