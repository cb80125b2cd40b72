// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/solids/box.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

#include "core/shapes/rays/line_interval.h"
#include "core/shapes/rays/solid_lanes.h"

namespace isoscope {

Box::Box(const glm::dvec3& low, const glm::dvec3& high)
    : low_(glm::min(low, high)), high_(glm::max(low, high)) {}

void Box::intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const {
    ++context.rays;
    appendEnds(ray, boxInterval(ray, low_, high_), interval, hits);
}

void Box::nearestInBatch(const RayBatch& rays, TraceContext& context, HitBatch& hits) const {
    context.rays += rays.size();
    if (isEmpty()) return;
    meetBox(low_, high_, {rays, context.nearLimit, !context.shadowRay, hits});
}

void Box::spans(const RayBatch& rays, SpanBatch& spans) const { findBoxSpans(low_, high_, rays, spans); }

bool Box::contains(const glm::dvec3& point, TraceContext&) const { return bounds().contains(point); }

/// The sides of a box are laid out as a cross: from the left those to -x, +z, +x and -z, and those to -y and
/// +y below and above the second, each a quarter wide and a third high.
std::optional<glm::dvec2> Box::surfacePlace(const glm::dvec3& point) const {
    glm::dvec3 s(0.5);
    int axis = 0;
    double nearest = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k) {
        const double size = high_[k] - low_[k];
        if (size > 0) s[k] = (point[k] - low_[k]) / size;
        const double away = std::min(std::abs(point[k] - low_[k]), std::abs(point[k] - high_[k]));
        if (away >= nearest) continue;
        nearest = away;
        axis = k;
    }
    const bool upper = s[axis] > 0.5;
    if (axis == 1) return glm::dvec2((1 + s.x) / 4, (upper ? 3 - s.z : s.z) / 3);
    const double across = axis == 0 ? (upper ? 3 - s.z : s.z) : (upper ? 1 + s.x : 4 - s.x);
    return glm::dvec2(across / 4, (1 + s.y) / 3);
}

}  // namespace isoscope
