// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/solids/sphere_sweep.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/shapes/rays/hit_list.h"

namespace isoscope {

namespace {

/// Points count as inside, as in POV-Ray, up to this much (of the squared distance) outside a sphere: where
/// surfaces coincide in CSG it decides what shows.
constexpr double skin = 1e-10;

/// A polynomial of the spline's parameter, constant first.
struct Polynomial {
    std::array<double, 11> c{};
    int degree = 0;

    double at(double u) const {
        double value = 0;
        for (int k = degree; k >= 0; --k) value = value * u + c[static_cast<std::size_t>(k)];
        return value;
    }
    Polynomial slope() const {
        Polynomial result;
        result.degree = std::max(degree - 1, 0);
        for (int k = 1; k <= degree; ++k)
            result.c[static_cast<std::size_t>(k - 1)] = k * c[static_cast<std::size_t>(k)];
        return result;
    }
    /// Adds factor a b.
    void addProduct(double factor, const Polynomial& a, const Polynomial& b) {
        degree = std::max(degree, a.degree + b.degree);
        for (std::size_t i = 0; i <= static_cast<std::size_t>(a.degree); ++i)
            for (std::size_t j = 0; j <= static_cast<std::size_t>(b.degree); ++j)
                c[i + j] += factor * a.c[i] * b.c[j];
    }
    void roots(RootSequence& found) const {
        std::array<double, 11> highestFirst;
        std::reverse_copy(c.begin(), c.begin() + degree + 1, highestFirst.begin());
        realRoots(std::span<const double>(highestFirst).first(static_cast<std::size_t>(degree) + 1), 0, 1,
                  found);
    }
};

/// r(u)^2 less the square of the distance of `point` from c(u).
Polynomial depthOf(const std::array<glm::dvec4, 4>& c, int degree, const glm::dvec3& point) {
    Polynomial result;
    for (int axis = 0; axis < 4; ++axis) {
        Polynomial component;
        component.degree = degree;
        for (std::size_t k = 0; k < 4; ++k) component.c[k] = c[k][axis];
        if (axis < 3) component.c[0] -= point[axis];
        result.addProduct(axis < 3 ? -1 : 1, component, component);
    }
    return result;
}

}  // namespace

SphereSweep::SphereSweep(SweepKind kind, std::span<const glm::dvec4> p) {
    for (std::size_t i = 0; i + 1 < p.size(); ++i) {
        if (kind == SweepKind::linear) {
            addPiece({p[i], p[i + 1] - p[i]}, 1);
            continue;
        }
        if (i + 3 >= p.size()) break;
        const glm::dvec4 &a = p[i], &b = p[i + 1], &c = p[i + 2], &d = p[i + 3];
        if (kind == SweepKind::bSpline)
            addPiece({(a + 4.0 * b + c) / 6.0, (c - a) / 2.0, (a - 2.0 * b + c) / 2.0,
                      (d - a + 3.0 * (b - c)) / 6.0},
                     3);
        else
            addPiece({b, (c - a) / 2.0, a - 2.5 * b + 2.0 * c - 0.5 * d, (d - a) / 2.0 + 1.5 * (b - c)}, 3);
    }
    center_ = bounds_.finite() ? (bounds_.low + bounds_.high) / 2.0 : glm::dvec3(0);
}

void SphereSweep::addPiece(const std::array<glm::dvec4, 4>& c, int degree) {
    Piece piece;
    piece.c = c;
    piece.degree = degree;
    // A spline lies in the hull of its Bezier points.
    const std::array<glm::dvec4, 4> hull{c[0], c[0] + c[1] / 3.0, c[0] + c[1] * (2.0 / 3.0) + c[2] / 3.0,
                                         c[0] + c[1] + c[2] + c[3]};
    Bounds box{glm::dvec3(INFINITY), glm::dvec3(-INFINITY)};
    for (const glm::dvec4& point : hull) {
        const glm::dvec3 at(point), radius(std::abs(point.w));
        box = {glm::min(box.low, at - radius), glm::max(box.high, at + radius)};
    }
    piece.middle = (box.low + box.high) / 2.0;
    for (const glm::dvec4& point : hull)
        piece.reach =
            std::max(piece.reach, glm::distance(glm::dvec3(point), piece.middle) + std::abs(point.w));
    bounds_ = pieces_.empty() ? box : unite(bounds_, box);
    pieces_.push_back(piece);
}

void SphereSweep::cover(std::size_t index, const CenteredRay& line, std::vector<Part>& parts) const {
    const Piece& piece = pieces_[index];
    std::array<glm::dvec4, 4> c = piece.c;
    c[0] -= glm::dvec4(center_, 0);
    // m: how far along the ray c(u) lies; D: what is left of r^2 beside the ray.
    Polynomial along;
    along.degree = piece.degree;
    for (std::size_t k = 0; k < 4; ++k) along.c[k] = glm::dot(glm::dvec3(c[k]), line.direction);
    along.c[0] -= glm::dot(line.origin, line.direction);
    Polynomial depth = depthOf(c, piece.degree, line.origin);
    depth.addProduct(1, along, along);
    RootSequence ends;
    depth.roots(ends);
    const Polynomial alongSlope = along.slope(), depthSlope = depth.slope();
    Polynomial square, turning;
    square.addProduct(4, alongSlope, alongSlope);
    turning.addProduct(1, square, depth);
    turning.addProduct(-1, depthSlope, depthSlope);
    RootSequence turns, tops;
    bool turnsKnown = false;
    for (std::size_t k = 0; k <= ends.size(); ++k) {
        const double from = k == 0 ? 0 : ends[k - 1], to = k == ends.size() ? 1 : ends[k];
        if (!(from < to) || !(depth.at(from + (to - from) / 2) > 0)) continue;
        if (!turnsKnown) {
            turning.roots(turns);
            // Where the ray runs across the sweep the roots above come in pairs, or double.
            depthSlope.roots(tops);
            turnsKnown = true;
        }
        Part part{{INFINITY, 0, index}, {-INFINITY, 0, index}};
        const auto offer = [&](double u) {
            const double half = std::sqrt(std::max(depth.at(u), 0.0)), middle = along.at(u);
            if (middle - half < part.enter.s) part.enter = {middle - half, u, index};
            if (middle + half > part.leave.s) part.leave = {middle + half, u, index};
        };
        offer(from);
        offer(to);
        for (const RootSequence* places : {&turns, &tops})
            for (const double u : *places)
                if (u > from && u < to) offer(u);
        parts.push_back(part);
    }
}

void SphereSweep::intersect(const Ray& ray, RayInterval interval, TraceContext& context,
                            HitList& hits) const {
    ++context.rays;
    const CenteredRay line(ray, center_);
    if (!line.usable) return;
    std::vector<Part> parts;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        const glm::dvec3 arm = pieces_[i].middle - center_ - line.origin;
        const glm::dvec3 across = arm - glm::dot(arm, line.direction) * line.direction;
        if (glm::length(across) <= pieces_[i].reach * (1 + 1e-9)) cover(i, line, parts);
    }
    std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.enter.s < b.enter.s; });
    const auto add = [&](const End& end) {
        const double t = line.toRay(end.s);
        if (interval.near <= t && t <= interval.far)
            hits.push_back({t, ray.at(t), normalAt(end, line.at(end.s))});
    };
    for (std::size_t i = 0; i < parts.size();) {
        Part joined = parts[i];
        for (++i; i < parts.size() && parts[i].enter.s <= joined.leave.s + 1e-10; ++i)
            if (parts[i].leave.s > joined.leave.s) joined.leave = parts[i].leave;
        add(joined.enter);
        add(joined.leave);
    }
}

glm::dvec3 SphereSweep::normalAt(const End& end, const glm::dvec3& point) const {
    return unitNormal(point - (glm::dvec3(pieces_[end.piece].at(end.u)) - center_));
}

bool SphereSweep::contains(const glm::dvec3& point, TraceContext&) const {
    if (!bounds_.contains(point)) return false;
    for (const Piece& piece : pieces_) {
        if (glm::distance(point, piece.middle) > piece.reach) continue;
        const Polynomial depth = depthOf(piece.c, piece.degree, point);
        if (depth.at(0) > -skin || depth.at(1) > -skin) return true;
        RootSequence tops;
        depth.slope().roots(tops);
        for (const double u : tops)
            if (depth.at(u) > -skin) return true;
    }
    return false;
}

}  // namespace isoscope
