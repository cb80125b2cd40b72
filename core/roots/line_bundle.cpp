// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/line_bundle.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace isoscope {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Box {
    glm::dvec3 low{infinity}, high{-infinity};

    void add(const glm::dvec3& point) { low = glm::min(low, point), high = glm::max(high, point); }
    glm::dvec3 middle() const { return 0.5 * (low + high); }
    /// Half widths, rounded up.
    glm::dvec3 spread() const {
        return glm::max(high - middle(), middle() - low) * (1 + 4 * std::numeric_limits<double>::epsilon());
    }
};

}  // namespace

std::optional<LineBundle> LineBundle::around(std::span<const LineQuery> queries,
                                             std::span<const std::uint8_t> wanted) {
    Box origins, directions;
    double near = infinity, far = -infinity;
    for (std::size_t i = 0; i < queries.size(); ++i) {
        if (!wanted[i]) continue;
        origins.add(queries[i].origin);
        directions.add(queries[i].direction);
        near = std::min(near, queries[i].near), far = std::max(far, queries[i].far);
    }
    if (!(near < far)) return {};
    const LineBundle bundle{
        origins.middle(), origins.spread(), directions.middle(), directions.spread(), near, far};
    if (!std::isfinite(bundle.width()) || !std::isfinite(far)) return {};
    return bundle;
}

double LineBundle::width() const {
    return glm::length(originSpread + far * directionSpread) / glm::length(direction);
}

void LineBundle::place(std::size_t lane, RayPieces& pieces, RaySpread& spread) const {
    for (int k = 0; k < 3; ++k) {
        pieces.origin[k][lane] = origin[k], spread.origin[k][lane] = originSpread[k];
        pieces.direction[k][lane] = direction[k], spread.direction[k][lane] = directionSpread[k];
    }
}

}  // namespace isoscope
