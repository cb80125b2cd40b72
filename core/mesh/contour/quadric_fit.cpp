// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/contour/quadric_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

namespace isoscope {

namespace {

/// Directions in which the planes say less than this, by eigenvalues against the largest, keep the middle:
/// about a crease of 15 degrees.
constexpr double leastWeight = 0.02;

using Matrix = std::array<std::array<double, 3>, 3>;

/// Turns one entry beside the diagonal of a symmetric matrix to 0.
void turn(Matrix& a, Matrix& vectors, std::size_t p, std::size_t q) {
    if (a[p][q] == 0) return;
    const double ratio = (a[q][q] - a[p][p]) / (2 * a[p][q]);
    const double t = (ratio >= 0 ? 1 : -1) / (std::abs(ratio) + std::sqrt(ratio * ratio + 1));
    const double c = 1 / std::sqrt(t * t + 1), s = t * c;
    for (std::size_t k = 0; k < 3; ++k) {
        const double x = a[k][p], y = a[k][q];
        a[k][p] = c * x - s * y;
        a[k][q] = s * x + c * y;
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const double x = a[p][k], y = a[q][k];
        a[p][k] = c * x - s * y;
        a[q][k] = s * x + c * y;
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const double x = vectors[k][p], y = vectors[k][q];
        vectors[k][p] = c * x - s * y;
        vectors[k][q] = s * x + c * y;
    }
}

/// The least x with a x = b, as far as `a`, symmetric and not negative, says something: Jacobi's rotations.
glm::dvec3 leastSolution(Matrix a, const glm::dvec3& b) {
    Matrix vectors{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    for (int sweep = 0; sweep < 8; ++sweep) {
        turn(a, vectors, 0, 1);
        turn(a, vectors, 0, 2);
        turn(a, vectors, 1, 2);
    }
    const double largest = std::max({a[0][0], a[1][1], a[2][2]});
    glm::dvec3 x(0);
    for (std::size_t k = 0; k < 3; ++k) {
        if (!(a[k][k] > leastWeight * largest)) continue;
        const glm::dvec3 direction(vectors[0][k], vectors[1][k], vectors[2][k]);
        x += glm::dot(direction, b) / a[k][k] * direction;
    }
    return x;
}

}  // namespace

glm::dvec3 QuadricFit::middle() const {
    glm::dvec3 sum(0);
    for (const Plane& plane : planes_) sum += plane.place;
    return sum / static_cast<double>(planes_.size());
}

glm::dvec3 QuadricFit::meanNormal() const {
    glm::dvec3 sum(0);
    for (const Plane& plane : planes_) sum += plane.normal;
    const double length = glm::length(sum);
    return length > 1e-9 ? sum / length : planes_.front().normal;
}

double QuadricFit::leastCosine() const {
    const glm::dvec3 mean = meanNormal();
    double least = 1;
    for (const Plane& plane : planes_) least = std::min(least, glm::dot(mean, plane.normal));
    return least;
}

glm::dvec3 QuadricFit::solve(const glm::dvec3& low, const glm::dvec3& high) const {
    const glm::dvec3 from = glm::clamp(middle(), low, high);
    Matrix a{};
    glm::dvec3 b(0);
    for (const Plane& plane : planes_) {
        const glm::dvec3& n = plane.normal;
        b += glm::dot(n, plane.place - from) * n;
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j) a[i][j] += n[static_cast<int>(i)] * n[static_cast<int>(j)];
    }
    const glm::dvec3 way = leastSolution(a, b);
    double share = 1;
    for (int k = 0; k < 3; ++k) {
        const double room = (way[k] > 0 ? high[k] : low[k]) - from[k];
        if (way[k] != 0 && std::abs(way[k]) > std::abs(room))
            share = std::min(share, std::abs(room / way[k]));
    }
    const glm::dvec3 point = from + share * way;
    return std::isfinite(point.x + point.y + point.z) ? point : from;
}

double QuadricFit::distance(const glm::dvec3& point) const {
    double most = 0;
    for (const Plane& plane : planes_)
        most = std::max(most, std::abs(glm::dot(plane.normal, point - plane.place)));
    return most;
}

}  // namespace isoscope
