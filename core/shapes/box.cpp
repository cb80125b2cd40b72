// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/box.h"

#include <glm/common.hpp>

#include "core/shapes/line_interval.h"

namespace isoscope {

Box::Box(const glm::dvec3& low, const glm::dvec3& high)
    : low_(glm::min(low, high)), high_(glm::max(low, high)) {}

void Box::intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const {
    ++context.rays;
    appendEnds(ray, boxInterval(ray, low_, high_), interval, hits);
}

bool Box::contains(const glm::dvec3& point, TraceContext&) const { return bounds().contains(point); }

}  // namespace isoscope
