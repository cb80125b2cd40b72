// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/patches/mesh.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "core/shapes/rays/hit_list.h"

namespace isoscope {

Mesh::Mesh(std::vector<glm::dvec3> points, std::vector<glm::dvec3> normals, std::vector<Face> faces,
           std::optional<glm::dvec3> insideDirection, std::vector<glm::dvec2> places)
    : points_(std::move(points)),
      normals_(std::move(normals)),
      faces_(std::move(faces)),
      places_(std::move(places)),
      insideDirection_(insideDirection) {
    for (glm::dvec3& normal : normals_) normal = unitNormal(normal);
    std::vector<Bounds> boxes;
    boxes.reserve(faces_.size());
    for (const Face& face : faces_) {
        const glm::dvec3 &a = points_[face.corners[0]], &b = points_[face.corners[1]],
                         &c = points_[face.corners[2]];
        boxes.push_back({glm::min(glm::min(a, b), c), glm::max(glm::max(a, b), c)});
        bounds_ = boxes.size() == 1 ? boxes.back() : unite(bounds_, boxes.back());
    }
    if (faces_.empty()) bounds_ = {glm::dvec3(0), glm::dvec3(0)};
    tree_ = Bvh(boxes);
}

std::optional<TriangleHit> Mesh::meet(const TriangleLine& line, std::size_t face) const {
    const std::array<std::uint32_t, 3>& corners = faces_[face].corners;
    return line.meet(points_[corners[0]], points_[corners[1]], points_[corners[2]]);
}

void Mesh::intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const {
    ++context.rays;
    const std::size_t first = hits.size();
    const TriangleLine line(ray);
    tree_.visit(ray, interval, [&](std::size_t face, double far) {
        const auto met = meet(line, face);
        if (met && interval.near <= met->t && met->t <= interval.far)
            hits.push_back({met->t, ray.at(met->t), normalAt(face, *met)});
        return far;
    });
    sortHits(hits, first);
}

void Mesh::nearest(std::span<const Ray> rays, TraceContext& context, std::span<NearestHit> nearest) const {
    context.rays += rays.size();
    for (std::size_t i = 0; i < rays.size(); ++i) {
        RayInterval interval{context.nearLimit, RayInterval().far};
        if (nearest[i].found) interval.far = nearest[i].hit.t;
        const TriangleLine line(rays[i]);
        std::optional<TriangleHit> best;
        std::size_t bestFace = 0;
        tree_.visit(rays[i], interval, [&](std::size_t face, double far) {
            const auto met = meet(line, face);
            if (!met || !(met->t >= interval.near) || !(met->t < far)) return far;
            best = met;
            bestFace = face;
            return met->t;
        });
        if (best) offer({best->t, rays[i].at(best->t), normalAt(bestFace, *best)}, nearest[i]);
    }
}

glm::dvec3 Mesh::normalAt(std::size_t index, const TriangleHit& met) const {
    const Face& face = faces_[index];
    if (face.smooth)
        return unitNormal(met.shares.x * normals_[face.normals[0]] +
                          met.shares.y * normals_[face.normals[1]] +
                          met.shares.z * normals_[face.normals[2]]);
    const glm::dvec3 &a = points_[face.corners[0]], &b = points_[face.corners[1]],
                     &c = points_[face.corners[2]];
    return unitNormal(glm::cross(c - a, b - a));
}

bool Mesh::contains(const glm::dvec3& point, TraceContext&) const {
    if (!insideDirection_ || !bounds_.contains(point)) return false;
    const Ray ray{point, *insideDirection_};
    const TriangleLine line(ray);
    bool inside = false;
    tree_.visit(ray, {}, [&](std::size_t face, double far) {
        const auto met = meet(line, face);
        if (met && met->t >= 0) inside = !inside;
        return far;
    });
    return inside;
}

/// A face is met by a line along one of the axes, unless it is seen edge on from there: the nearest of those
/// that are met by any of the three.
Mesh::Spot Mesh::spotOf(const glm::dvec3& point) const {
    Spot spot;
    double nearest = std::numeric_limits<double>::infinity();
    const double reach = 1e-6 * (1 + glm::length(point));
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 direction(0);
        direction[axis] = 1;
        const Ray ray{point, direction};
        const TriangleLine line(ray);
        tree_.visit(ray, {-reach, reach}, [&](std::size_t face, double far) {
            const auto met = meet(line, face);
            if (!met || !(std::abs(met->t) < nearest)) return far;
            nearest = std::abs(met->t);
            spot = {&faces_[face], met->shares};
            return far;
        });
    }
    return spot;
}

std::optional<glm::dvec2> Mesh::surfacePlace(const glm::dvec3& point) const {
    const Spot spot = places_.empty() ? Spot() : spotOf(point);
    if (!spot.face) return glm::dvec2(0);
    glm::dvec2 place(0);
    for (int k = 0; k < 3; ++k)
        place += spot.shares[k] * places_[spot.face->places[static_cast<std::size_t>(k)]];
    return place;
}

std::vector<TextureShare> Mesh::textureShares(const glm::dvec3& point) const {
    const Spot spot = spotOf(point);
    if (!spot.face) return {{0, 1}};
    const auto& [a, b, c] = spot.face->textures;
    if (a == b && b == c) return {{a, 1}};
    return {{a, spot.shares.x}, {b, spot.shares.y}, {c, spot.shares.z}};
}

}  // namespace isoscope
