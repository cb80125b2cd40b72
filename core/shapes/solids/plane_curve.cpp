// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/solids/plane_curve.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace isoscope {

namespace {

CurvePiece linePiece(const glm::dvec2& a, const glm::dvec2& b) { return {{a, b - a}, 1}; }

/// The parabola through three points at u = -1, 0, 1.
CurvePiece parabola(const glm::dvec2& before, const glm::dvec2& a, const glm::dvec2& b) {
    return {{a, (b - before) * 0.5, (before - 2.0 * a + b) * 0.5}, 2};
}

CurvePiece hermite(const glm::dvec2& a, const glm::dvec2& slopeA, const glm::dvec2& b,
                   const glm::dvec2& slopeB) {
    return {{a, slopeA, 3.0 * (b - a) - 2.0 * slopeA - slopeB, 2.0 * (a - b) + slopeA + slopeB}, 3};
}

CurvePiece bezierPiece(std::span<const glm::dvec2> p) {
    return {{p[0], 3.0 * (p[1] - p[0]), 3.0 * (p[0] - 2.0 * p[1] + p[2]), p[3] - p[0] + 3.0 * (p[1] - p[2])},
            3};
}

}  // namespace

int leastPoints(SplineKind kind) {
    switch (kind) {
        case SplineKind::linear: return 2;
        case SplineKind::quadratic: return 3;
        case SplineKind::cubic:
        case SplineKind::bezier: break;
    }
    return 4;
}

void CurvePiece::meet(const glm::dvec2& a, double value, RootSequence& roots) const {
    std::array<double, 4> polynomial{};
    for (std::size_t k = 0; k < 4; ++k)
        polynomial[3 - k] = a.x * c[k].x + a.y * c[k].y - (k == 0 ? value : 0);
    realRoots(std::span<const double>(polynomial).last(static_cast<std::size_t>(degree) + 1), 0, 1, roots);
}

void CurvePiece::range(glm::dvec2& low, glm::dvec2& high) const {
    low = glm::min(at(0), at(1));
    high = glm::max(at(0), at(1));
    for (int axis = 0; axis < 2; ++axis) {
        RootSequence turns;
        realRoots(std::array<double, 3>{3 * c[3][axis], 2 * c[2][axis], c[1][axis]}, 0, 1, turns);
        for (const double u : turns) {
            low[axis] = std::min(low[axis], at(u)[axis]);
            high[axis] = std::max(high[axis], at(u)[axis]);
        }
    }
}

std::vector<CurvePiece> curveThrough(SplineKind kind, std::span<const glm::dvec2> p) {
    std::vector<CurvePiece> pieces;
    const std::size_t n = p.size();
    switch (kind) {
        case SplineKind::linear:
            for (std::size_t i = 0; i + 1 < n; ++i) pieces.push_back(linePiece(p[i], p[i + 1]));
            break;
        case SplineKind::quadratic:
            for (std::size_t i = 1; i + 1 < n; ++i) pieces.push_back(parabola(p[i - 1], p[i], p[i + 1]));
            break;
        case SplineKind::cubic:
            for (std::size_t i = 1; i + 2 < n; ++i)
                pieces.push_back(
                    hermite(p[i], (p[i + 1] - p[i - 1]) * 0.5, p[i + 1], (p[i + 2] - p[i]) * 0.5));
            break;
        case SplineKind::bezier:
            for (std::size_t i = 0; i + 3 < n; i += 4) pieces.push_back(bezierPiece(p.subspan(i, 4)));
            break;
    }
    return pieces;
}

Outline::Outline(std::vector<CurvePiece> pieces) : pieces_(std::move(pieces)) {
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        glm::dvec2 low, high;
        pieces_[i].range(low, high);
        low_ = i == 0 ? low : glm::min(low_, low);
        high_ = i == 0 ? high : glm::max(high_, high);
        boxes_.push_back({0.5 * (low + high), 0.5 * (high - low)});
        addArcs(i);
    }
    joinLevels();
}

void Outline::addArcs(std::size_t index) {
    const CurvePiece& piece = pieces_[index];
    RootSequence turns;
    realRoots(std::array<double, 3>{3 * piece.c[3].y, 2 * piece.c[2].y, piece.c[1].y}, 0, 1, turns);
    std::vector<double> ends{0};
    for (const double u : turns)
        if (u > 0 && u < 1) ends.push_back(u);
    ends.push_back(1);
    glm::dvec2 low, high;
    piece.range(low, high);
    for (std::size_t k = 0; k + 1 < ends.size(); ++k)
        arcs_.push_back(
            {index, ends[k], ends[k + 1], piece.at(ends[k]).y, piece.at(ends[k + 1]).y, low.x, high.x});
}

/// The end of one piece and the beginning of its neighbour, which are known exactly, must not differ by
/// rounding: a line on that very level would cross both or none.
void Outline::joinLevels() {
    std::vector<double> starts;
    for (const CurvePiece& piece : pieces_) starts.push_back(piece.at(0).y);
    std::sort(starts.begin(), starts.end());
    for (Arc& arc : arcs_) {
        if (arc.to != 1) continue;
        const double room = 1e-12 * (1 + std::abs(arc.yTo));
        const auto near = std::lower_bound(starts.begin(), starts.end(), arc.yTo - room);
        if (near != starts.end() && *near <= arc.yTo + room) arc.yTo = *near;
    }
}

bool Outline::covers(const glm::dvec2& point) const {
    bool inside = false;
    for (const Arc& arc : arcs_) {
        if ((arc.yFrom > point.y) == (arc.yTo > point.y) || arc.right <= point.x) continue;
        if (arc.left > point.x) {
            inside = !inside;
            continue;
        }
        // The only place on the arc at this height, by halving and secants in turn.
        const CurvePiece& piece = pieces_[arc.piece];
        double a = arc.from, b = arc.to, fa = arc.yFrom - point.y, fb = arc.yTo - point.y;
        for (int step = 0; step < 100 && b - a > 1e-15; ++step) {
            double u = step % 2 == 0 ? a - fa * (b - a) / (fb - fa) : (a + b) / 2;
            if (!(u > a && u < b)) u = (a + b) / 2;
            const double f = piece.at(u).y - point.y;
            if (f == 0) {
                a = b = u;
                break;
            }
            if ((f > 0) == (fa > 0))
                a = u, fa = f;
            else
                b = u, fb = f;
        }
        if (piece.at((a + b) / 2).x > point.x) inside = !inside;
    }
    return inside;
}

}  // namespace isoscope
