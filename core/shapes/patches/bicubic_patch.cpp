// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/patches/bicubic_patch.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace isoscope {

namespace {

using Points = BicubicPatch::Points;

std::array<double, 4> weights(double t) {
    const double s = 1 - t;
    return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
}

std::array<double, 4> slopes(double t) {
    const double s = 1 - t;
    return {-3 * s * s, 3 * s * s - 6 * s * t, 6 * s * t - 3 * t * t, 3 * t * t};
}

glm::dvec3 blend(const Points& p, const std::array<double, 4>& u, const std::array<double, 4>& v) {
    glm::dvec3 sum(0);
    for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t column = 0; column < 4; ++column) sum += u[column] * v[row] * p[4 * row + column];
    return sum;
}

glm::dvec3 normalAt(const Points& p, double u, double v) {
    const auto cross = [&](double a, double b) {
        return glm::cross(blend(p, weights(a), slopes(b)), blend(p, slopes(a), weights(b)));
    };
    const glm::dvec3 normal = cross(u, v);
    // Where an edge is drawn together to one point, the normal just beside it.
    if (glm::length(normal) > 1e-12) return normal;
    return cross(std::clamp(u, 1e-4, 1 - 1e-4), std::clamp(v, 1e-4, 1 - 1e-4));
}

/// How far the inner points lie off the corners' bilinear patch, at most: halving a side divides that by
/// four.
double bend(const Points& p) {
    double most = 0;
    for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t column = 0; column < 4; ++column) {
            const double u = static_cast<double>(column) / 3, v = static_cast<double>(row) / 3;
            const glm::dvec3 flat = (1 - v) * ((1 - u) * p[0] + u * p[3]) + v * ((1 - u) * p[12] + u * p[15]);
            most = std::max(most, glm::distance(flat, p[4 * row + column]));
        }
    return most;
}

}  // namespace

BicubicPatch::BicubicPatch(const Points& p, int uSteps, int vSteps, double flatness,
                           const std::array<glm::dvec2, 4>& corners)
    : bounds_{p[0], p[0]} {
    for (const glm::dvec3& point : p) bounds_ = unite(bounds_, {point, point});
    int enough = 8;
    if (flatness > 0)
        for (enough = 0; enough < 8 && bend(p) / std::exp2(2 * enough) > flatness;) ++enough;
    const int columns = 1 << std::min(vSteps, enough), rows = 1 << std::min(uSteps, enough);
    std::vector<glm::dvec3> points, normals;
    std::vector<glm::dvec2> places;
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column) {
            const double u = static_cast<double>(column) / columns, v = static_cast<double>(row) / rows;
            points.push_back(blend(p, weights(u), weights(v)));
            normals.push_back(normalAt(p, u, v));
            places.push_back((1 - v) * ((1 - u) * corners[0] + u * corners[1]) +
                             v * ((1 - u) * corners[3] + u * corners[2]));
        }
    std::vector<Mesh::Face> faces;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const auto a = static_cast<std::uint32_t>(row * (columns + 1) + column), b = a + 1,
                       c = a + static_cast<std::uint32_t>(columns) + 1, d = c + 1;
            // POV-Ray divides along this diagonal, which the normals between the corners show.
            faces.push_back({{a, b, d}, {a, b, d}, true, {a, b, d}});
            faces.push_back({{a, d, c}, {a, d, c}, true, {a, d, c}});
        }
    mesh_ = std::make_shared<Mesh>(std::move(points), std::move(normals), std::move(faces), std::nullopt,
                                   std::move(places));
}

}  // namespace isoscope
