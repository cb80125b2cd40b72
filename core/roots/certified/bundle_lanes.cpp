// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/certified/bundle_lanes.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/roots/certified/bundle_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, batchLanes>;
using Vector = hn::Vec<Doubles>;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The smallest lanes of eight vectors, all of them together: one by one their lanes would be waited for.
HWY_INLINE void leastOf(const Vector (&columns)[8], double (&least)[8]) {
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

/// Puts the least and the greatest numbers of lines whose interval is not empty into lane `lane`: the least
/// into origin and direction, the greatest into the spreads.
HWY_INLINE void measureLines(const LineColumns& lines, const LineRange& range, std::size_t lane,
                             BundleLanes& bundles) {
    const Doubles d;
    const std::size_t first = range.first, count = range.count;
    const Vector infinite = hn::Set(d, infinity);
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
    for (std::size_t c = 0; c < 3; ++c) {
        bundles.direction[c][lane] = found[c];
        bundles.directionSpread[c][lane] = -found[3 + c];
        bundles.origin[c][lane] = bundles.originSpread[c][lane] = lines.origin[c][first];
    }
    bundles.near[lane] = found[6], bundles.far[lane] = -found[7];
    if (hn::AllFalse(d, elsewhere)) return;
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
    for (std::size_t c = 0; c < 3; ++c) {
        bundles.origin[c][lane] = found[c];
        bundles.originSpread[c][lane] = -found[3 + c];
    }
}

void measureAll(const LineColumns& lines, const LineRange* ranges, std::size_t count, BundleLanes& bundles) {
    for (std::size_t k = 0; k < count; ++k) measureLines(lines, ranges[k], k, bundles);
}

/// From the least and the greatest numbers of lines, as measureLines() leaves them, to bundles.
void spreadAll(std::size_t count, BundleLanes& bundles) {
    const Doubles d;
    // Half widths are rounded up.
    const Vector up = hn::Set(d, 1 + 4 * std::numeric_limits<double>::epsilon());
    for (std::size_t k = 0; k < count; k += hn::Lanes(d)) {
        const auto at = [k](BundleLanes::Lanes& lanes) HWY_ATTR { return &lanes[k]; };
        const Vector far = hn::LoadU(d, at(bundles.far));
        Vector across = hn::Zero(d), along = across;
        const auto spread = [&](BundleLanes::Lanes& lows, BundleLanes::Lanes& highs,
                                Vector& middle) HWY_ATTR {
            const Vector low = hn::LoadU(d, at(lows)), high = hn::LoadU(d, at(highs));
            middle = hn::Mul(hn::Set(d, 0.5), hn::Add(low, high));
            const Vector half = hn::Mul(hn::Max(hn::Sub(high, middle), hn::Sub(middle, low)), up);
            hn::StoreU(middle, d, at(lows));
            hn::StoreU(half, d, at(highs));
            return half;
        };
        for (std::size_t c = 0; c < 3; ++c) {
            Vector origin, direction;
            const Vector beside = spread(bundles.origin[c], bundles.originSpread[c], origin);
            const Vector turned = spread(bundles.direction[c], bundles.directionSpread[c], direction);
            const Vector reach = hn::MulAdd(far, turned, beside);
            across = hn::MulAdd(reach, reach, across);
            along = hn::MulAdd(direction, direction, along);
        }
        const Vector width = hn::Sqrt(hn::Div(across, along));
        const Vector near = hn::LoadU(d, at(bundles.near));
        const auto finite = hn::And(hn::Lt(far, hn::Set(d, infinity)), hn::Lt(width, hn::Set(d, infinity)));
        const auto usable = hn::And(hn::Lt(near, far), finite);
        hn::StoreU(width, d, at(bundles.width));
        hn::StoreU(hn::IfThenElse(usable, far, hn::Neg(hn::Set(d, infinity))), d, at(bundles.far));
    }
}

}  // namespace
}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <glm/common.hpp>

namespace isoscope {

HWY_EXPORT(measureAll);
HWY_EXPORT(spreadAll);

void BundleLanes::enclose(const LineColumns& lines, std::span<const LineRange> ranges) {
    HWY_DYNAMIC_DISPATCH(measureAll)(lines, ranges.data(), ranges.size(), *this);
    HWY_DYNAMIC_DISPATCH(spreadAll)(ranges.size(), *this);
}

void BundleLanes::enclose(std::span<const LineQuery> queries, std::span<const std::uint8_t> wanted,
                          std::span<const LineRange> ranges) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < ranges.size(); ++k) {
        glm::dvec3 lowOrigin(infinity), highOrigin(-infinity), lowDirection(infinity),
            highDirection(-infinity);
        near[k] = infinity, far[k] = -infinity;
        for (std::size_t i = ranges[k].first; i < ranges[k].first + ranges[k].count; ++i) {
            if (!wanted[i]) continue;
            const LineQuery& line = queries[i];
            lowOrigin = glm::min(lowOrigin, line.origin), highOrigin = glm::max(highOrigin, line.origin);
            lowDirection = glm::min(lowDirection, line.direction);
            highDirection = glm::max(highDirection, line.direction);
            near[k] = std::min(near[k], line.near), far[k] = std::max(far[k], line.far);
        }
        for (int c = 0; c < 3; ++c) {
            const auto axis = static_cast<std::size_t>(c);
            origin[axis][k] = lowOrigin[c], originSpread[axis][k] = highOrigin[c];
            direction[axis][k] = lowDirection[c], directionSpread[axis][k] = highDirection[c];
        }
    }
    HWY_DYNAMIC_DISPATCH(spreadAll)(ranges.size(), *this);
}

LineBundle BundleLanes::operator[](std::size_t k) const {
    const auto at = [k](const std::array<Lanes, 3>& lanes) {
        return glm::dvec3(lanes[0][k], lanes[1][k], lanes[2][k]);
    };
    return {at(origin), at(originSpread), at(direction), at(directionSpread), near[k], far[k], width[k]};
}

void BundleLanes::place(std::size_t k, std::size_t lane, RayPieces& pieces, RaySpread& spread) const {
    for (std::size_t c = 0; c < 3; ++c) {
        pieces.origin[c][lane] = origin[c][k], spread.origin[c][lane] = originSpread[c][k];
        pieces.direction[c][lane] = direction[c][k], spread.direction[c][lane] = directionSpread[c][k];
    }
}

}  // namespace isoscope
#endif
