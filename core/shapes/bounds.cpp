// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/bounds.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec4.hpp>
#include <utility>

namespace isoscope {

bool Bounds::finite() const {
    for (int axis = 0; axis < 3; ++axis)
        if (!std::isfinite(low[axis]) || !std::isfinite(high[axis])) return false;
    return true;
}

bool Bounds::contains(const glm::dvec3& point) const {
    for (int axis = 0; axis < 3; ++axis)
        if (!(low[axis] <= point[axis] && point[axis] <= high[axis])) return false;
    return true;
}

RayInterval Bounds::clip(const Ray& ray) const {
    const RayInterval nothing{1, 0};
    RayInterval inside;
    for (int axis = 0; axis < 3; ++axis) {
        const double origin = ray.origin[axis];
        const double direction = ray.direction[axis];
        if (!std::isfinite(origin) || !std::isfinite(direction)) return nothing;
        if (direction == 0) {
            if (!(low[axis] <= origin && origin <= high[axis])) return nothing;
            continue;
        }
        double enter = (low[axis] - origin) / direction;
        double leave = (high[axis] - origin) / direction;
        if (enter > leave) std::swap(enter, leave);
        inside.near = std::max(inside.near, enter);
        inside.far = std::min(inside.far, leave);
    }
    // A swapped pair hides that the box itself is empty.
    for (int axis = 0; axis < 3; ++axis)
        if (!(low[axis] <= high[axis])) return nothing;
    return inside;
}

Bounds unite(const Bounds& a, const Bounds& b) {
    const auto empty = [](const Bounds& box) {
        return !(box.low.x <= box.high.x && box.low.y <= box.high.y && box.low.z <= box.high.z);
    };
    if (empty(a)) return b;
    if (empty(b)) return a;
    return {glm::min(a.low, b.low), glm::max(a.high, b.high)};
}

Bounds intersect(const Bounds& a, const Bounds& b) {
    return {glm::max(a.low, b.low), glm::min(a.high, b.high)};
}

Bounds transform(const Bounds& bounds, const glm::dmat4& matrix) {
    if (!bounds.finite()) return {};
    Bounds result{glm::dvec3(std::numeric_limits<double>::infinity()),
                  glm::dvec3(-std::numeric_limits<double>::infinity())};
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 from((corner & 1) != 0 ? bounds.high.x : bounds.low.x,
                              (corner & 2) != 0 ? bounds.high.y : bounds.low.y,
                              (corner & 4) != 0 ? bounds.high.z : bounds.low.z);
        const glm::dvec3 to(matrix * glm::dvec4(from, 1));
        result.low = glm::min(result.low, to);
        result.high = glm::max(result.high, to);
    }
    return result;
}

Bounds image(const Bounds& bounds, const glm::dmat4& matrix) {
    Bounds result;
    for (int row = 0; row < 3; ++row) {
        double low = matrix[3][row], high = low;
        for (int column = 0; column < 3; ++column) {
            const double factor = matrix[column][row];
            // Otherwise 0 times infinity.
            if (factor == 0) continue;
            const double one = factor * bounds.low[column], other = factor * bounds.high[column];
            low += std::min(one, other);
            high += std::max(one, other);
        }
        result.low[row] = low;
        result.high[row] = high;
    }
    return result;
}

Bounds grown(const Bounds& bounds) {
    constexpr double room = 1e-9;
    return {bounds.low - room * (1.0 + glm::abs(bounds.low)),
            bounds.high + room * (1.0 + glm::abs(bounds.high))};
}

}  // namespace isoscope
