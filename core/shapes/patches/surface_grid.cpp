// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/patches/surface_grid.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <unordered_map>

#include "core/shapes/patches/triangle.h"

namespace isoscope {

namespace {

/// Of a place in whole steps; 0 and -0 are the same place.
struct PlaceHash {
    std::size_t operator()(const std::array<double, 3>& place) const {
        std::size_t hash = 0;
        for (const double step : place) hash = hash * 0x9e3779b97f4a7c15u + std::hash<double>()(step);
        return hash;
    }
};

}  // namespace

std::vector<std::array<std::uint32_t, 3>> SurfaceGrid::triangles() const {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
        if (Triangle::degenerate({points[a], points[b], points[c]})) return;
        triangles.push_back(
            {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(c)});
    };
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const std::size_t a = number(column, row), b = number(column + 1, row),
                              c = number(column, row + 1), d = number(column + 1, row + 1);
            add(a, b, c);
            add(b, d, c);
        }
    return triangles;
}

void SurfaceGrid::smoothen() {
    double size = 0;
    for (const glm::dvec3& point : points)
        for (int axis = 0; axis < 3; ++axis)
            if (std::isfinite(point[axis])) size = std::max(size, std::abs(point[axis]));
    const double unit = std::max(size, 1e-300) * 1e-9;
    std::unordered_map<std::array<double, 3>, std::size_t, PlaceHash> places;
    places.reserve(points.size());
    std::vector<std::size_t> place(points.size(), 0);
    for (std::size_t i = 0; i < points.size(); ++i) {
        std::array<double, 3> key{};
        for (int axis = 0; axis < 3; ++axis) {
            const double step = std::round(points[i][axis] / unit);
            // NaN has no order; such points belong to no triangle.
            key[static_cast<std::size_t>(axis)] = std::isfinite(step) ? step : 0;
        }
        place[i] = places.emplace(key, places.size()).first->second;
    }
    std::vector<glm::dvec3> sums(places.size(), glm::dvec3(0));
    for (const auto& corners : triangles()) {
        const glm::dvec3 &a = points[corners[0]], &b = points[corners[1]], &c = points[corners[2]];
        const glm::dvec3 area = glm::cross(c - a, b - a);
        for (const std::uint32_t corner : corners) sums[place[corner]] += area;
    }
    normals.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) normals[i] = sums[place[i]];
}

std::shared_ptr<const Mesh> SurfaceGrid::mesh(std::optional<glm::dvec3> insideDirection) const {
    std::vector<Mesh::Face> faces;
    for (const auto& corners : triangles()) {
        Mesh::Face face{corners, corners, !normals.empty()};
        // A normal that does not exist would darken the whole triangle.
        for (const std::uint32_t corner : corners)
            face.smooth = face.smooth && glm::dot(normals[corner], normals[corner]) > 0;
        faces.push_back(face);
    }
    if (faces.empty()) return nullptr;
    std::vector<glm::dvec3> finite = points;
    for (glm::dvec3& point : finite)
        if (!(glm::dot(point, point) < INFINITY)) point = glm::dvec3(0);
    return std::make_shared<Mesh>(std::move(finite), normals, std::move(faces), insideDirection);
}

}  // namespace isoscope
