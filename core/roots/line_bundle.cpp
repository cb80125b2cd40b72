// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/line_bundle.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/roots/line_bundle.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <limits>

#ifndef ISOSCOPE_ROOTS_LINE_BUNDLE_ONCE
#define ISOSCOPE_ROOTS_LINE_BUNDLE_ONCE
namespace isoscope {

/// The smallest and the largest number of every column.
struct ColumnExtents {
    glm::dvec3 lowOrigin, highOrigin, lowDirection, highDirection;
    double near, far;
};

}  // namespace isoscope
#endif

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::ScalableTag<double>;
using Vector = hn::Vec<Doubles>;

/// Of the lines whose interval is not empty.
void measureLines(const LineColumns& lines, std::size_t first, std::size_t count, ColumnExtents& extents) {
    const Doubles d;
    const Vector infinite = hn::Set(d, std::numeric_limits<double>::infinity());
    Vector low[8], high[8];
    for (int c = 0; c < 8; ++c) low[c] = infinite, high[c] = hn::Neg(infinite);
    for (std::size_t k = 0; k < count; k += hn::Lanes(d)) {
        const std::size_t i = first + k;
        const Vector near = hn::LoadU(d, lines.near + i), far = hn::LoadU(d, lines.far + i);
        const auto wanted = hn::And(hn::FirstN(d, count - k), hn::Lt(near, far));
        const auto take = [&](int c, Vector value) HWY_ATTR {
            low[c] = hn::IfThenElse(wanted, hn::Min(low[c], value), low[c]);
            high[c] = hn::IfThenElse(wanted, hn::Max(high[c], value), high[c]);
        };
        for (int c = 0; c < 3; ++c) {
            take(c, hn::LoadU(d, lines.origin[static_cast<std::size_t>(c)] + i));
            take(3 + c, hn::LoadU(d, lines.direction[static_cast<std::size_t>(c)] + i));
        }
        take(6, near);
        take(7, far);
    }
    const auto least = [&](int c) HWY_ATTR { return hn::GetLane(hn::MinOfLanes(d, low[c])); };
    const auto most = [&](int c) HWY_ATTR { return hn::GetLane(hn::MaxOfLanes(d, high[c])); };
    for (int c = 0; c < 3; ++c) {
        // All rays of a camera begin in one place.
        const double place = lines.origin[static_cast<std::size_t>(c)][first];
        const Vector same = hn::Set(d, place);
        const auto elsewhere = hn::Or(hn::Lt(low[c], same), hn::Gt(high[c], same));
        const bool together = hn::AllFalse(d, elsewhere);
        extents.lowOrigin[c] = together ? place : least(c);
        extents.highOrigin[c] = together ? place : most(c);
        extents.lowDirection[c] = least(3 + c), extents.highDirection[c] = most(3 + c);
    }
    extents.near = least(6), extents.far = most(7);
}

}  // namespace
}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace isoscope {

HWY_EXPORT(measureLines);

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

std::optional<LineBundle> bundleOf(const Box& origins, const Box& directions, double near, double far) {
    if (!(near < far)) return {};
    LineBundle bundle{
        origins.middle(), origins.spread(), directions.middle(), directions.spread(), near, far};
    bundle.width =
        glm::length(bundle.originSpread + far * bundle.directionSpread) / glm::length(bundle.direction);
    if (!std::isfinite(bundle.width) || !std::isfinite(far)) return {};
    return bundle;
}

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
    return bundleOf(origins, directions, near, far);
}

std::optional<LineBundle> LineBundle::around(const LineColumns& lines, std::size_t first, std::size_t count) {
    ColumnExtents extents;
    HWY_DYNAMIC_DISPATCH(measureLines)(lines, first, count, extents);
    return bundleOf({extents.lowOrigin, extents.highOrigin}, {extents.lowDirection, extents.highDirection},
                    extents.near, extents.far);
}

void LineBundle::place(std::size_t lane, RayPieces& pieces, RaySpread& spread) const {
    for (int k = 0; k < 3; ++k) {
        pieces.origin[k][lane] = origin[k], spread.origin[k][lane] = originSpread[k];
        pieces.direction[k][lane] = direction[k], spread.direction[k][lane] = directionSpread[k];
    }
}

}  // namespace isoscope
#endif
