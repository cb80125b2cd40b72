// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/threshold/newton_test.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace isoscope {

namespace {

std::array<Interval, 3> atPoint(const glm::dvec3& p) {
    return {Interval::point(p.x), Interval::point(p.y), Interval::point(p.z)};
}

/// Rows and columns as glm numbers them.
const SlopeRange& entryOf(const std::array<SlopeRange, 6>& bend, int row, int column) {
    return bend[bendIndex(static_cast<std::size_t>(row), static_cast<std::size_t>(column))];
}

glm::dmat3 middleOf(const std::array<SlopeRange, 6>& bend) {
    glm::dmat3 middle;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const SlopeRange& b = entryOf(bend, i, j);
            middle[i][j] = 0.5 * b.low + 0.5 * b.high;
        }
    return middle;
}

/// Nothing for a matrix without one, or almost.
std::optional<glm::dmat3> inverseOf(const glm::dmat3& matrix) {
    const glm::dmat3 inverse = glm::inverse(matrix);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            if (!(std::abs(inverse[i][j]) < 1e100)) return {};
    return inverse;
}

bool isEmpty(const GradientBox& box) {
    return !(box.low.x <= box.high.x && box.low.y <= box.high.y && box.low.z <= box.high.z);
}

SlopeRange around(const GradientBox& box, const glm::dvec3& p, int k) {
    return {lowered(box.low[k] - p[k]), raised(box.high[k] - p[k])};
}

/// The matrix of the eigenvectors of a symmetric matrix, by Jacobi's rotations; good enough is enough.
glm::dmat3 eigenvectorsOf(glm::dmat3 a) {
    constexpr int sweeps = 12;
    glm::dmat3 vectors(1);
    for (int sweep = 0; sweep < sweeps; ++sweep)
        for (int p = 0; p < 3; ++p)
            for (int q = p + 1; q < 3; ++q) {
                if (a[p][q] == 0) continue;
                const double angle = 0.5 * std::atan2(2 * a[p][q], a[p][p] - a[q][q]);
                glm::dmat3 turn(1);
                turn[p][p] = turn[q][q] = std::cos(angle);
                turn[p][q] = std::sin(angle);
                turn[q][p] = -std::sin(angle);
                a = glm::transpose(turn) * a * turn;
                vectors = vectors * turn;
            }
    return vectors;
}

}  // namespace

bool NewtonTest::covers(const IntervalGradient& whole) {
    if (!whole.bounded() || !whole.smooth || whole.pieced || whole.value.empty() ||
        whole.value.maybeUndefined || whole.wrap != 0)
        return false;
    return std::all_of(whole.bend.begin(), whole.bend.end(),
                       [](const SlopeRange& b) { return b.isFinite(); });
}

NewtonVerdict NewtonTest::test(const GradientBox& box, const IntervalGradient& whole) {
    using enum NewtonVerdict::Kind;
    const std::array<SlopeRange, 6> bend = whole.bend;
    const glm::dvec3 center = box.center();
    const IntervalGradient& at = intervals_.evaluate(atPoint(center));
    if (!at.bounded() || at.value.empty()) return {open, box};
    std::array<SlopeRange, 3> way;
    for (int k = 0; k < 3; ++k) way[static_cast<std::size_t>(k)] = around(box, center, k);
    for (int i = 0; i < 3; ++i) {
        SlopeRange slope = at.slope[static_cast<std::size_t>(i)];
        for (int j = 0; j < 3; ++j) slope = slope + entryOf(bend, i, j) * way[static_cast<std::size_t>(j)];
        if (slope.low > 0 || slope.high < 0) return {none, box};
    }
    const std::optional<glm::dmat3> inverse = inverseOf(middleOf(bend));
    if (!inverse) return {open, box};
    // K = m - C f'(m) + (1 - C f''(X)) (X - m); C is an approximate inverse.
    NewtonVerdict verdict{one, box};
    double contraction = 0;
    for (int i = 0; i < 3; ++i) {
        SlopeRange move{0, 0}, spread{0, 0};
        double row = 0;
        for (int j = 0; j < 3; ++j) {
            // glm's matrices are read by columns; this one is symmetric but for roundings, which do not
            // count.
            const double c = (*inverse)[j][i];
            move = move - c * at.slope[static_cast<std::size_t>(j)];
            SlopeRange entry{i == j ? 1.0 : 0.0, i == j ? 1.0 : 0.0};
            for (int k = 0; k < 3; ++k) entry = entry - (*inverse)[k][i] * entryOf(bend, k, j);
            spread = spread + entry * way[static_cast<std::size_t>(j)];
            row = raised(row + entry.size());
        }
        contraction = std::max(contraction, row);
        const SlopeRange to = SlopeRange{center[i], center[i]} + move + spread;
        if (!to.isFinite()) return {open, box};
        if (!(to.low > box.low[i] && to.high < box.high[i])) verdict.kind = atMostOne;
        verdict.rest.low[i] = std::max(box.low[i], to.low);
        verdict.rest.high[i] = std::min(box.high[i], to.high);
    }
    if (isEmpty(verdict.rest)) return {none, box};
    // Without a contraction there may be several zeros, but none outside of the rest.
    if (!(contraction < 1)) verdict.kind = open;
    return verdict;
}

std::optional<glm::dvec3> NewtonTest::stepsFrom(glm::dvec3 point, double reach) {
    constexpr int steps = 8;
    const glm::dvec3 start = point;
    for (int step = 0; step < steps; ++step) {
        const IntervalGradient& at = intervals_.evaluate(atPoint(point));
        if (!covers(at)) return {};
        const std::optional<glm::dmat3> inverse = inverseOf(middleOf(at.bend));
        if (!inverse) return {};
        glm::dvec3 slope;
        for (int k = 0; k < 3; ++k) {
            const SlopeRange& s = at.slope[static_cast<std::size_t>(k)];
            slope[k] = 0.5 * s.low + 0.5 * s.high;
        }
        const glm::dvec3 move = *inverse * slope;
        point -= move;
        if (!(glm::length(point - start) <= reach)) return {};
        if (glm::length(move) <= 1e-13 * reach) break;
    }
    return point;
}

std::optional<NewtonTest::Found> NewtonTest::lookAround(const GradientBox& box,
                                                        const IntervalGradient& whole) {
    constexpr int tries = 6;
    const double reach = 2 * glm::length(box.high - box.low);
    if (!covers(whole)) return {};
    const std::optional<glm::dvec3> zero = stepsFrom(box.center(), reach);
    if (!zero) return {};
    // Large enough to hold the box, if that can be.
    glm::dvec3 half;
    for (int k = 0; k < 3; ++k)
        half[k] = 1.01 * std::max({box.high[k] - (*zero)[k], (*zero)[k] - box.low[k], 0.25 * box.width()});
    for (int attempt = 0; attempt < tries; ++attempt, half *= 0.4) {
        const GradientBox alone{*zero - half, *zero + half};
        const IntervalGradient around = intervals_.evaluate(alone.intervals());
        if (!covers(around)) continue;
        const NewtonVerdict verdict = test(alone, around);
        if (verdict.kind == NewtonVerdict::Kind::one) return Found{alone, narrow(verdict.rest)};
        if (verdict.kind == NewtonVerdict::Kind::none) return {};
    }
    return {};
}

GradientBox NewtonTest::narrow(GradientBox box) {
    constexpr int steps = 40;
    for (int step = 0; step < steps; ++step) {
        const IntervalGradient whole = intervals_.evaluate(box.intervals());
        if (!covers(whole)) break;
        const NewtonVerdict verdict = test(box, whole);
        if (verdict.kind == NewtonVerdict::Kind::none) break;
        const double before = box.width();
        box = verdict.rest;
        if (!(box.width() < 0.9 * before)) break;
    }
    return box;
}

CriticalKind NewtonTest::kindIn(const GradientBox& box) {
    const IntervalGradient whole = intervals_.evaluate(box.intervals());
    if (!covers(whole)) return CriticalKind::unknown;
    // A matrix keeps its signs under a change of base (Sylvester); in that of its eigenvectors the
    // circles of Gershgorin are small.
    const glm::dmat3 base = eigenvectorsOf(middleOf(whole.bend));
    std::array<std::array<SlopeRange, 3>, 3> turned{};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            SlopeRange sum{0, 0};
            for (int k = 0; k < 3; ++k)
                for (int l = 0; l < 3; ++l) {
                    const SlopeRange product =
                        SlopeRange{base[i][k], base[i][k]} * SlopeRange{base[j][l], base[j][l]};
                    sum = sum + product * entryOf(whole.bend, k, l);
                }
            turned[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = sum;
        }
    int falling = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        double radius = 0;
        for (std::size_t j = 0; j < 3; ++j)
            if (j != i) radius = raised(radius + turned[i][j].size());
        const SlopeRange& middle = turned[i][i];
        if (middle.high + radius < 0 && raised(middle.high + radius) < 0)
            ++falling;
        else if (!(lowered(middle.low - radius) > 0))
            return CriticalKind::unknown;
    }
    constexpr CriticalKind kinds[] = {CriticalKind::minimum, CriticalKind::saddle1, CriticalKind::saddle2,
                                      CriticalKind::maximum};
    return kinds[falling];
}

}  // namespace isoscope
