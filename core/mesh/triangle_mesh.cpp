// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/triangle_mesh.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <numeric>

#include "core/mesh/joined_sets.h"

namespace isoscope {

namespace {

constexpr std::uint32_t white = 0xffffffff;

/// One side of a triangle, with its ends in order.
struct Side {
    std::uint32_t low, high;
    std::uint32_t corner;  ///< 3 times the triangle, plus the corner that it begins at
    bool forwards;         ///< from low to high

    bool sameEdge(const Side& other) const { return low == other.low && high == other.high; }
    bool operator<(const Side& other) const {
        if (low != other.low) return low < other.low;
        return high != other.high ? high < other.high : corner < other.corner;
    }
};

std::vector<Side> sidesOf(const std::vector<Triangle>& triangles) {
    std::vector<Side> sides;
    sides.reserve(3 * triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = triangles[t][k], b = triangles[t][(k + 1) % 3];
            sides.push_back({std::min(a, b), std::max(a, b), static_cast<std::uint32_t>(3 * t + k), a < b});
        }
    std::sort(sides.begin(), sides.end());
    return sides;
}

/// Calls visit(first, behind) for the sides of each edge.
template <class Visit>
void forEachEdge(const std::vector<Side>& sides, Visit visit) {
    for (std::size_t i = 0; i < sides.size();) {
        std::size_t end = i + 1;
        while (end < sides.size() && sides[end].sameEdge(sides[i])) ++end;
        visit(i, end);
        i = end;
    }
}

/// The corner of the same triangle at the other end of a side.
std::uint32_t endCorner(std::uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }

/// Joins the corners that lie at the same point in triangles with an edge in common: each set is a fan.
JoinedSets fansOf(const std::vector<Triangle>& triangles, const std::vector<Side>& sides) {
    JoinedSets fans(3 * triangles.size());
    forEachEdge(sides, [&](std::size_t first, std::size_t end) {
        for (std::size_t i = first + 1; i < end; ++i) {
            const std::uint32_t a = sides[first].corner, b = sides[i].corner;
            const bool same = sides[first].forwards == sides[i].forwards;
            fans.join(a, same ? b : endCorner(b));
            fans.join(endCorner(a), same ? endCorner(b) : b);
        }
    });
    return fans;
}

double angleAt(const TriangleMesh& mesh, const Triangle& triangle, std::size_t k) {
    const glm::dvec3 a = mesh.points[triangle[(k + 1) % 3]] - mesh.points[triangle[k]];
    const glm::dvec3 b = mesh.points[triangle[(k + 2) % 3]] - mesh.points[triangle[k]];
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

}  // namespace

void TriangleMesh::append(const TriangleMesh& other) {
    const auto firstPoint = static_cast<std::uint32_t>(points.size());
    const auto firstNormal = static_cast<std::uint32_t>(normals.size());
    const std::size_t firstTriangle = triangles.size();
    if (colors.empty() != other.colors.empty()) colors.resize(points.size(), white);
    points.insert(points.end(), other.points.begin(), other.points.end());
    normals.insert(normals.end(), other.normals.begin(), other.normals.end());
    colors.insert(colors.end(), other.colors.begin(), other.colors.end());
    if (!colors.empty()) colors.resize(points.size(), white);
    for (const Triangle& t : other.triangles)
        triangles.push_back({t[0] + firstPoint, t[1] + firstPoint, t[2] + firstPoint});
    for (const Triangle& t : other.cornerNormals)
        cornerNormals.push_back({t[0] + firstNormal, t[1] + firstNormal, t[2] + firstNormal});
    for (const std::size_t begin : other.objects)
        if (begin + firstTriangle != 0) objects.push_back(begin + firstTriangle);
}

std::vector<glm::dvec3> TriangleMesh::pointNormals() const {
    std::vector<glm::dvec3> sums(points.size(), glm::dvec3(0));
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k)
            sums[triangles[t][k]] += angleAt(*this, triangles[t], k) * normals[cornerNormals[t][k]];
    for (glm::dvec3& sum : sums) {
        const double length = glm::length(sum);
        sum = length > 0 ? sum / length : glm::dvec3(0, 0, 1);
    }
    return sums;
}

void TriangleMesh::transform(const glm::dmat4& matrix) {
    const glm::dmat3 turn(matrix), turnNormals = glm::transpose(glm::inverse(turn));
    for (glm::dvec3& p : points) p = glm::dvec3(matrix * glm::dvec4(p, 1));
    for (glm::dvec3& n : normals) {
        const glm::dvec3 turned = turnNormals * n;
        const double length = glm::length(turned);
        if (length > 0 && std::isfinite(length)) n = turned / length;
    }
    if (glm::determinant(turn) >= 0) return;
    for (Triangle& t : triangles) std::swap(t[1], t[2]);
    for (Triangle& t : cornerNormals) std::swap(t[1], t[2]);
}

MeshForm formOf(const TriangleMesh& mesh) {
    MeshForm form;
    form.triangles = mesh.triangles.size();
    const std::vector<Side> sides = sidesOf(mesh.triangles);
    JoinedSets pieces(mesh.points.size()), borders(mesh.points.size());
    std::vector<std::uint8_t> onBorder(mesh.points.size(), 0), used(mesh.points.size(), 0);
    forEachEdge(sides, [&](std::size_t first, std::size_t end) {
        const Side& side = sides[first];
        ++form.edges;
        pieces.join(side.low, side.high);
        used[side.low] = used[side.high] = 1;
        if (end - first == 1) {
            ++form.borderEdges;
            borders.join(side.low, side.high);
            onBorder[side.low] = onBorder[side.high] = 1;
        } else if (end - first > 2 || side.forwards == sides[first + 1].forwards) {
            ++form.oddEdges;
        }
    });
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        form.points += used[i];
        form.pieces += used[i] != 0 && pieces.find(i) == i ? 1 : 0;
        form.borders += onBorder[i] != 0 && borders.find(i) == i ? 1 : 0;
    }
    JoinedSets fans = fansOf(mesh.triangles, sides);
    std::vector<std::uint8_t> fanCount(mesh.points.size(), 0);
    for (std::size_t corner = 0; corner < 3 * mesh.triangles.size(); ++corner) {
        std::uint8_t& count = fanCount[mesh.triangles[corner / 3][corner % 3]];
        if (fans.find(corner) == corner && count < 2) ++count;
    }
    form.oddPoints = static_cast<std::size_t>(std::count(fanCount.begin(), fanCount.end(), 2));
    return form;
}

void separateFans(TriangleMesh& mesh) {
    JoinedSets fans = fansOf(mesh.triangles, sidesOf(mesh.triangles));
    constexpr std::uint32_t none = ~std::uint32_t(0);
    std::vector<std::uint32_t> ownerOf(mesh.points.size(), none), pointOf(3 * mesh.triangles.size(), none);
    for (std::size_t corner = 0; corner < 3 * mesh.triangles.size(); ++corner) {
        std::uint32_t& point = mesh.triangles[corner / 3][corner % 3];
        const auto fan = static_cast<std::uint32_t>(fans.find(corner));
        if (pointOf[fan] == none) {
            if (ownerOf[point] == none) {
                ownerOf[point] = fan;
                pointOf[fan] = point;
            } else {
                pointOf[fan] = static_cast<std::uint32_t>(mesh.points.size());
                mesh.points.push_back(mesh.points[point]);
                if (!mesh.colors.empty()) mesh.colors.push_back(mesh.colors[point]);
            }
        }
        point = pointOf[fan];
    }
}

}  // namespace isoscope
