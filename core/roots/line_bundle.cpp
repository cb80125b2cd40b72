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

/// The smallest lanes of eight vectors, all of them together: one by one their lanes would be waited for.
void leastOf(const Vector (&columns)[8], double (&least)[8]) {
    [[maybe_unused]] const Doubles d;
#if HWY_TARGET == HWY_SCALAR
    for (std::size_t c = 0; c < 8; ++c) least[c] = hn::GetLane(columns[c]);
#else
    HWY_ALIGN double pairs[hn::MaxLanes(d)];
    for (std::size_t c = 0; c < 8; c += 2) {
        const Vector lower = hn::InterleaveLower(d, columns[c], columns[c + 1]);
        const Vector upper = hn::InterleaveUpper(d, columns[c], columns[c + 1]);
        hn::Store(hn::Min(lower, upper), d, pairs);
        least[c] = pairs[0], least[c + 1] = pairs[1];
        for (std::size_t k = 2; k < hn::Lanes(d); k += 2) {
            least[c] = pairs[k] < least[c] ? pairs[k] : least[c];
            least[c + 1] = pairs[k + 1] < least[c + 1] ? pairs[k + 1] : least[c + 1];
        }
    }
#endif
}

/// Of the lines whose interval is not empty.
void measureLines(const LineColumns& lines, std::size_t first, std::size_t count, ColumnExtents& extents) {
    const Doubles d;
    const Vector infinite = hn::Set(d, std::numeric_limits<double>::infinity());
    const Vector endless = hn::Neg(infinite);
    Vector low[4] = {infinite, infinite, infinite, infinite}, high[4] = {endless, endless, endless, endless};
    // All rays of a camera begin in one place.
    Vector place[3];
    for (std::size_t c = 0; c < 3; ++c) place[c] = hn::Set(d, lines.origin[c][first]);
    auto elsewhere = hn::Lt(infinite, infinite);
    for (std::size_t k = 0; k < count; k += hn::Lanes(d)) {
        const std::size_t i = first + k;
        const Vector near = hn::LoadU(d, lines.near + i), far = hn::LoadU(d, lines.far + i);
        const auto wanted = hn::And(hn::FirstN(d, count - k), hn::Lt(near, far));
        const bool all = hn::AllTrue(d, wanted);
        if (!all && hn::AllFalse(d, wanted)) continue;
        const auto take = [&](std::size_t c, Vector least, Vector most) HWY_ATTR {
            low[c] = hn::Min(low[c], all ? least : hn::IfThenElse(wanted, least, infinite));
            high[c] = hn::Max(high[c], all ? most : hn::IfThenElse(wanted, most, endless));
        };
        for (std::size_t c = 0; c < 3; ++c) {
            const Vector direction = hn::LoadU(d, lines.direction[c] + i);
            take(c, direction, direction);
            const auto same = hn::Eq(hn::LoadU(d, lines.origin[c] + i), place[c]);
            elsewhere = hn::Or(elsewhere, hn::AndNot(same, wanted));
        }
        take(3, near, far);
    }
    // Directions, their negatives, near, -far.
    Vector least[8] = {low[0],           low[1],           low[2], hn::Neg(high[0]),
                       hn::Neg(high[1]), hn::Neg(high[2]), low[3], hn::Neg(high[3])};
    double found[8];
    leastOf(least, found);
    extents.lowDirection = {found[0], found[1], found[2]};
    extents.highDirection = {-found[3], -found[4], -found[5]};
    extents.near = found[6], extents.far = -found[7];
    if (hn::AllFalse(d, elsewhere)) {
        extents.lowOrigin =
            extents.highOrigin = {lines.origin[0][first], lines.origin[1][first], lines.origin[2][first]};
        return;
    }
    for (Vector& column : least) column = infinite;
    for (std::size_t k = 0; k < count; k += hn::Lanes(d)) {
        const std::size_t i = first + k;
        const auto wanted = hn::And(hn::FirstN(d, count - k),
                                    hn::Lt(hn::LoadU(d, lines.near + i), hn::LoadU(d, lines.far + i)));
        for (std::size_t c = 0; c < 3; ++c) {
            const Vector origin = hn::LoadU(d, lines.origin[c] + i);
            least[c] = hn::Min(least[c], hn::IfThenElse(wanted, origin, infinite));
            least[3 + c] = hn::Min(least[3 + c], hn::IfThenElse(wanted, hn::Neg(origin), infinite));
        }
    }
    leastOf(least, found);
    extents.lowOrigin = {found[0], found[1], found[2]};
    extents.highOrigin = {-found[3], -found[4], -found[5]};
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
