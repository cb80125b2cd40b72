// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/light/light_grid.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/render/camera/place_random.h"

namespace isoscope {

namespace {

/// -0.5 to 0.5 over all of them; a single one is in the middle. `moved` counts in steps.
double along(int number, int count, double moved) {
    const double place = number + moved;
    return count > 1 ? place / (count - 1) - 0.5 : moved;
}

}  // namespace

LightGrid::LightGrid(const LightSource& light, const glm::dvec3& point)
    : light_(light), area_(*light.area), point_(point), edge_(area_.edge), otherEdge_(area_.otherEdge) {
    if (!area_.orient) return;
    const glm::dvec3 view = point - light.location;
    const double distance = glm::length(view);
    if (!(distance > 0)) return;
    glm::dvec3 across = glm::cross(view, glm::dvec3(0, 0, 1));
    if (glm::length(across) < 1e-6 * distance) across = {1, 0, 0};
    const glm::dvec3 first = glm::normalize(across);
    // Both are as long as the first one, as in POV-Ray (measured).
    edge_ = glm::length(area_.edge) * first;
    otherEdge_ = glm::length(area_.edge) * glm::cross(first, view / distance);
}

glm::dvec3 LightGrid::place(int column, int row) const {
    double u = 0, v = 0;
    if (area_.jitter) {
        PlaceRandom random(point_,
                           static_cast<std::uint64_t>(row) << 32 | static_cast<std::uint32_t>(column));
        u = random.next() - 0.5;
        v = random.next() - 0.5;
    }
    u = along(column, area_.columns, u);
    v = along(row, area_.rows, v);
    // The square becomes a disc: its corners come as near as the middles of its sides.
    if ((area_.circular || area_.orient) && (u != 0 || v != 0)) {
        const double scale = std::max(std::abs(u), std::abs(v)) / std::hypot(u, v);
        u *= scale;
        v *= scale;
    }
    return light_.location + u * edge_ + v * otherEdge_;
}

}  // namespace isoscope
