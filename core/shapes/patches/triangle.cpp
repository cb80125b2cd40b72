// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/patches/triangle.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/shapes/patches/triangle_hit.h"
#include "core/shapes/rays/hit_list.h"

namespace isoscope {

namespace {

glm::dvec3 doubledArea(const Triangle::Corners& corners) {
    return glm::cross(corners[2] - corners[0], corners[1] - corners[0]);
}

}  // namespace

Triangle::Triangle(const Corners& corners, const std::optional<Corners>& normals)
    : corners_(corners), smooth_(normals.has_value()) {
    const glm::dvec3 flat = unitNormal(doubledArea(corners));
    normals_ = normals.value_or(Corners{flat, flat, flat});
    for (glm::dvec3& normal : normals_) normal = unitNormal(normal);
}

bool Triangle::degenerate(const Corners& corners) {
    double longest = 0;
    for (int k = 0; k < 3; ++k)
        longest = std::max(longest, glm::distance(corners[static_cast<std::size_t>(k)],
                                                  corners[static_cast<std::size_t>((k + 1) % 3)]));
    const double area = glm::length(doubledArea(corners));
    return !(area > 1e-14 * longest * longest) || !std::isfinite(area);
}

void Triangle::intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const {
    ++context.rays;
    const auto met = TriangleLine(ray).meet(corners_[0], corners_[1], corners_[2]);
    if (!met || !(interval.near <= met->t && met->t <= interval.far)) return;
    glm::dvec3 normal = normals_[0];
    if (smooth_)
        normal = unitNormal(met->shares.x * normals_[0] + met->shares.y * normals_[1] +
                            met->shares.z * normals_[2]);
    hits.push_back({met->t, ray.at(met->t), normal});
}

Bounds Triangle::bounds() const {
    return {glm::min(glm::min(corners_[0], corners_[1]), corners_[2]),
            glm::max(glm::max(corners_[0], corners_[1]), corners_[2])};
}

}  // namespace isoscope
