// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/tables/sample_bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace isoscope {

namespace {

/// More than what rounding moves coordinates and values by, as a part of them.
constexpr double roundings = 1e-12;

/// How far joined samples can leave the middle of their extent along an axis, and how steep they are, in
/// parts of half the extent, and how much they bend within a cell: the largest sum of the sizes of the
/// weights (for Catmull and Rom's 5/4, half way between samples), of their first derivatives (3, in the same
/// place) and of their second ones (12, at the samples).
struct Reach {
    int before, behind;  ///< samples that count besides the one at or below
    double overshoot, slope, bend;
};
Reach reachOf(SampleJoin join) {
    switch (join) {
        case SampleJoin::none: return {0, 0, 1, 0, 0};
        case SampleJoin::linear: return {0, 1, 1, 2, 0};
        case SampleJoin::cubic: return {1, 2, 1.25, 3, 12};
    }
    return {};
}

/// How far rounding may have moved coordinates.
double slackOf(const Interval& side) {
    return roundings * (1 + std::max(std::abs(side.low), std::abs(side.high)));
}

/// Stretches of places within an axis, at most two.
struct Stretches {
    std::array<std::pair<int, int>, 2> ends;
    std::size_t count = 0;
    void add(int first, int last) { ends[count++] = {first, last}; }
};

/// Where the places from `first` to `last` lie within an axis.
Stretches stretchesOf(const SampleAxis& axis, double first, double last) {
    Stretches found;
    const int end = axis.size - 1;
    const auto held = [&](double place) {
        if (!axis.wrapsBelow) place = std::max(place, 0.0);
        return axis.wrapsAbove ? place : std::min(place, static_cast<double>(end));
    };
    first = held(first);
    last = held(last);
    // Further away whole numbers cannot be told apart well enough.
    constexpr double furthest = 1e12;
    if (last - first >= end || std::abs(first) > furthest || std::abs(last) > furthest) {
        found.add(0, end);
        return found;
    }
    const double turn = axis.size * std::floor(first / axis.size);
    const int low = static_cast<int>(first - turn), high = static_cast<int>(last - turn);
    found.add(low, std::min(high, end));
    if (high > end) found.add(0, high - axis.size);
    return found;
}

}  // namespace

SampleBounds::SampleBounds(const std::array<SampleAxis, 3>& axes, SampleJoin join, Sample sample)
    : axes_(axes), join_(join), sample_(std::move(sample)) {
    levels_.push_back({{axes[0].size, axes[1].size, axes[2].size}, {}});
    while (levels_.back().size != Places{1, 1, 1}) addLevel();
}

SampleBounds::Extent SampleBounds::at(std::size_t level, const Places& place) const {
    if (level == 0) {
        // Single precision may be rounded either way.
        const double value = sample_(place);
        constexpr float infinite = std::numeric_limits<float>::infinity();
        const auto rounded = static_cast<float>(value);
        if (static_cast<double>(rounded) == value) return {rounded, rounded};
        return {std::nextafter(rounded, -infinite), std::nextafter(rounded, infinite)};
    }
    const Level& cells = levels_[level];
    const auto index = [](int i) { return static_cast<std::size_t>(i); };
    return cells.extents[(index(place[2]) * index(cells.size[1]) + index(place[1])) * index(cells.size[0]) +
                         index(place[0])];
}

void SampleBounds::addLevel() {
    const std::size_t below = levels_.size() - 1;
    const std::array<int, 3> sizeBelow = levels_[below].size;
    Level level;
    for (std::size_t k = 0; k < 3; ++k) level.size[k] = (sizeBelow[k] + 1) / 2;
    for (int z = 0; z < level.size[2]; ++z)
        for (int y = 0; y < level.size[1]; ++y)
            for (int x = 0; x < level.size[0]; ++x) {
                Extent extent = at(below, {2 * x, 2 * y, 2 * z});
                for (int corner = 1; corner < 8; ++corner) {
                    const Places place{2 * x + corner % 2, 2 * y + corner / 2 % 2, 2 * z + corner / 4};
                    if (place[0] >= sizeBelow[0] || place[1] >= sizeBelow[1] || place[2] >= sizeBelow[2])
                        continue;
                    const Extent other = at(below, place);
                    extent = {std::min(extent.low, other.low), std::max(extent.high, other.high)};
                }
                level.extents.push_back(extent);
            }
    levels_.push_back(std::move(level));
}

/// Of the samples between two places, by the level at which they are few cells.
SampleBounds::Extent SampleBounds::between(const Places& first, const Places& last) const {
    constexpr int few = 2;
    std::size_t level = 0;
    const auto isFew = [&](std::size_t k) { return (last[k] >> level) - (first[k] >> level) <= few; };
    while (!isFew(0) || !isFew(1) || !isFew(2)) ++level;
    Extent extent = at(level, {first[0] >> level, first[1] >> level, first[2] >> level});
    for (int z = first[2] >> level; z <= last[2] >> level; ++z)
        for (int y = first[1] >> level; y <= last[1] >> level; ++y)
            for (int x = first[0] >> level; x <= last[0] >> level; ++x) {
                const Extent other = at(level, {x, y, z});
                extent = {std::min(extent.low, other.low), std::max(extent.high, other.high)};
            }
    return extent;
}

/// Those that count in a box.
SampleBounds::Samples SampleBounds::samplesOf(const std::array<Interval, 3>& box) const {
    const Reach reach = reachOf(join_);
    std::array<Stretches, 3> stretches;
    bool oneCell = true;
    for (std::size_t k = 0; k < 3; ++k) {
        if (axes_[k].size == 1) {
            stretches[k].add(0, 0);
            continue;
        }
        const double slack = slackOf(box[k]);
        const double shift = join_ == SampleJoin::none ? 0 : axes_[k].firstAt;
        const double first = std::floor(box[k].low - slack - shift),
                     last = std::floor(box[k].high + slack - shift);
        oneCell = oneCell && first == last;
        stretches[k] = stretchesOf(axes_[k], first - reach.before, last + reach.behind);
    }
    Extent extent{std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()};
    for (std::size_t z = 0; z < stretches[2].count; ++z)
        for (std::size_t y = 0; y < stretches[1].count; ++y)
            for (std::size_t x = 0; x < stretches[0].count; ++x) {
                const std::array<std::pair<int, int>, 3> ends{stretches[0].ends[x], stretches[1].ends[y],
                                                              stretches[2].ends[z]};
                const Extent other = between({ends[0].first, ends[1].first, ends[2].first},
                                             {ends[0].second, ends[1].second, ends[2].second});
                extent = {std::min(extent.low, other.low), std::max(extent.high, other.high)};
            }
    return {extent, oneCell};
}

/// Of the axes with several samples.
double SampleBounds::overshoot() const {
    double product = 1;
    for (const SampleAxis& axis : axes_)
        if (axis.size > 1) product *= reachOf(join_).overshoot;
    return product;
}

Interval SampleBounds::over(const std::array<Interval, 3>& box, double middle) const {
    const Extent extent = samplesOf(box).extent;
    const double low = extent.low, high = extent.high;
    if (join_ == SampleJoin::none) return {low, high, false};
    const double center = low + (high - low) / 2, half = (high - low) / 2 * overshoot();
    const double rounding = roundings * std::max(std::abs(low), std::abs(high));
    double way = 0;
    for (std::size_t k = 0; k < 3; ++k)
        if (axes_[k].size > 1) way += (box[k].high - box[k].low) / 2 + slackOf(box[k]);
    const double wide = half + rounding, narrow = half * reachOf(join_).slope * way + rounding;
    return {std::max(center - wide, middle - narrow), std::min(center + wide, middle + narrow), false};
}

PointTable::Straightness SampleBounds::straightness(const std::array<Interval, 3>& box,
                                                    const std::array<double, 3>& slope,
                                                    const std::array<double, 3>& errors) const {
    if (join_ == SampleJoin::none) return {};
    const auto [extent, oneCell] = samplesOf(box);
    if (join_ == SampleJoin::linear && !oneCell) return {};
    const Reach reach = reachOf(join_);
    const double half = (static_cast<double>(extent.high) - extent.low) / 2 * overshoot();
    double length = 0, squares = 0, moved = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        if (axes_[k].size == 1) continue;
        length += std::abs(slope[k]);
        squares += slope[k] * slope[k];
        moved += errors[k] + slackOf(box[k]);
    }
    // Second derivatives along one axis, and along two: twice the product of the ways counts for each pair.
    const double pairs = length * length - squares;
    const double second = half * (reach.bend * squares + reach.slope * reach.slope * pairs);
    const double rounding = roundings * std::max(std::abs(double(extent.low)), std::abs(double(extent.high)));
    return {second / 2 * (1 + roundings) + rounding, half * reach.slope * moved + rounding};
}

}  // namespace isoscope
