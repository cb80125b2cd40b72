// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/evaluate/algebra/interval_gradient_rules.h"
#include "core/numeric/crackle_candidates.h"
#include "core/numeric/crackle_sight.h"

namespace isoscope::gradient_rules {

namespace {

/// More than what the roundings of a distance, its powers and its slopes amount to.
constexpr double roundings = 1e-12;
/// Beyond these, coordinates have no cell, give or take.
constexpr double lastCell = 4e18;
/// Which cell point is at which rank is looked at one by one for so many combinations.
constexpr std::size_t combinationLimit = 128;

using Slopes = std::array<SlopeRange, 3>;

/// (a^m + b^m + c^m + d^m)^(1/m) of numbers that are not negative, without underflow.
double norm(const std::array<double, 4>& v, double metric) {
    const double most = *std::ranges::max_element(v);
    if (!(most > 0)) return 0;
    double sum = 0;
    for (const double x : v) sum += metric == 2 ? (x / most) * (x / most) : std::pow(x / most, metric);
    return most * (metric == 2 ? std::sqrt(sum) : std::pow(sum, 1 / metric));
}

/// The distance to a cell point over a box, and its slopes.
struct Distance {
    double low = 0, high = 0;
    Slopes slope;
    bool always = false;  ///< whether all points of the box look at the cell point
    bool cusp = false;    ///< whether a slope has no bound
};

/// Part `apart` of a distance whose other parts have the norm `rest`: from -1 to 1.
double share(double apart, double rest, double metric) {
    if (apart == 0) return 0;
    const double ratio = rest / std::abs(apart);
    const double whole =
        metric == 2 ? std::sqrt(1 + ratio * ratio) : std::pow(1 + std::pow(ratio, metric), 1 / metric);
    return std::copysign(1 / whole, apart);
}

/// The slope along an axis for shares between two: sign(t) |t|^(m - 1).
SlopeRange slopeOf(double low, double high, double metric) {
    const auto power = [&](double t) {
        if (metric == 2) return t;
        return std::copysign(std::pow(std::abs(t), metric - 1), t);
    };
    SlopeRange slope;
    if (metric == 1)
        slope = {low > 0 ? 1.0 : -1.0, high < 0 ? -1.0 : 1.0};
    else if (metric > 1)
        slope = {power(low), power(high)};
    else if (low > 0 || high < 0)
        slope = {power(high), power(low)};
    else
        return SlopeRange::within(unlimited);
    return {slope.low - roundings * std::abs(slope.low) - outwards,
            slope.high + roundings * std::abs(slope.high) + outwards};
}

/// Over the box between two corners.
Distance distanceTo(const std::array<double, 3>& point, const std::array<double, 3>& low,
                    const std::array<double, 3>& high, const CrackleSettings& settings) {
    Slopes way;
    std::array<double, 4> least{0, 0, 0, std::abs(settings.offset)}, most = least;
    for (std::size_t k = 0; k < 3; ++k) {
        way[k] = {lowered(low[k] - point[k]), raised(high[k] - point[k])};
        least[k] = way[k].gap();
        most[k] = way[k].size();
    }
    const double m = settings.metric;
    Distance distance;
    distance.low = norm(least, m) * (1 - roundings);
    distance.high = norm(most, m) * (1 + roundings) + outwards;
    for (std::size_t k = 0; k < 3; ++k) {
        std::array<double, 4> nearRest = least, farRest = most;
        nearRest[k] = farRest[k] = 0;
        const double nearest = norm(nearRest, m), furthest = norm(farRest, m);
        distance.slope[k] = slopeOf(share(way[k].low, way[k].low > 0 ? furthest : nearest, m),
                                    share(way[k].high, way[k].high > 0 ? nearest : furthest, m), m);
        distance.cusp = distance.cusp || !distance.slope[k].isFinite();
    }
    return distance;
}

/// The distances that may be among the three nearest of a box, and which of them at which rank.
class Ranking {
  public:
    explicit Ranking(std::size_t order) : order_(order) {}

    void add(const Distance& distance) { distances_.push_back(distance); }

    /// After the last one. False when fewer are looked at from everywhere than there are ranks.
    bool finish() {
        std::vector<double> lows, highs;
        for (const Distance& d : distances_) {
            lows.push_back(d.low);
            if (d.always) highs.push_back(d.high);
        }
        if (highs.size() < order_) return false;
        std::ranges::sort(lows);
        std::ranges::sort(highs);
        // What is further than the last rank is no part of any.
        std::erase_if(distances_, [&](const Distance& d) { return d.low > highs[order_ - 1]; });
        for (std::size_t rank = 0; rank < order_; ++rank) {
            low_[rank] = lows[rank];
            high_[rank] = highs[rank];
            for (const Distance& d : distances_)
                if (d.low <= high_[rank] && d.high >= low_[rank]) at_[rank].push_back(&d);
        }
        return true;
    }

    /// Whether places of the box see different cell points of which it matters, whether one of those that
    /// count has no bound of its slope, and how many may be the nearest.
    bool mayJump() const {
        return std::ranges::any_of(distances_, [](const Distance& d) { return !d.always; });
    }
    bool hasCusp() const {
        return std::ranges::any_of(distances_, [](const Distance& d) { return d.cusp; });
    }
    std::size_t nearestCount() const { return at_[0].size(); }

    /// The weighted sum of the distances, and its slopes in all combinations of cell points.
    SlopeRange sum(const std::array<double, 3>& form) const {
        SlopeRange total;
        for (std::size_t rank = 0; rank < order_; ++rank)
            total = total + form[rank] * SlopeRange{low_[rank], high_[rank]};
        return total;
    }
    /// Returns the length of the longest gradient.
    double gather(const std::array<double, 3>& form, Slopes& slope) const {
        std::size_t combinations = 1;
        double most = 0;
        for (std::size_t rank = 0; rank < order_; ++rank) {
            if (form[rank] == 0) continue;
            combinations *= at_[rank].size();
            most = raised(most + std::abs(form[rank]));
            SlopeRange reach[3];
            for (std::size_t k = 0; k < 3; ++k) {
                reach[k] = at_[rank].front()->slope[k];
                for (const Distance* d : at_[rank]) reach[k] = hull(reach[k], d->slope[k]);
                slope[k] = slope[k] + form[rank] * reach[k];
            }
        }
        if (combinations > combinationLimit) return unlimited;
        return longest(form, 0, {});
    }

  private:
    double longest(const std::array<double, 3>& form, std::size_t rank, const Slopes& before) const {
        if (rank == order_) return lengthAbove(before);
        if (form[rank] == 0) return longest(form, rank + 1, before);
        double most = 0;
        for (const Distance* d : at_[rank]) {
            Slopes slope = before;
            for (std::size_t k = 0; k < 3; ++k) slope[k] = slope[k] + form[rank] * d->slope[k];
            most = std::max(most, longest(form, rank + 1, slope));
        }
        return most;
    }

    std::size_t order_;
    std::vector<Distance> distances_;
    std::array<double, 3> low_{}, high_{};
    std::array<std::vector<const Distance*>, 3> at_;
};

std::size_t orderOf(const CrackleSettings& settings) {
    if (settings.solid) return 1;
    return settings.form[2] != 0 ? 3 : settings.form[1] != 0 ? 2 : 1;
}

/// At least the length of any gradient beside jumps; infinite in metrics below 1. A distance climbs by at
/// most 3^(1/m - 1/2), and never by more than 1 from 2 on.
double steepestCrackle(const CrackleSettings& settings) {
    if (!(settings.metric >= 1)) return unlimited;
    const double climb = settings.metric >= 2 ? 1 : std::pow(3, 1 / settings.metric - 0.5) * (1 + 1e-12);
    double steepness = 0;
    for (const double form : settings.form) steepness = raised(steepness + std::abs(form));
    return raised(steepness * climb);
}

/// A value with no slope longer than `steepness`.
IntervalGradient within(double steepness, Operands places, const Interval& value) {
    const SlopeRange any = SlopeRange::within(steepness);
    return ofThree(places, value, {any, any, any}, steepness);
}

void addJump(IntervalGradient& result) { result.hazard = worse(result.hazard, GradientHazard::jump); }

/// In a box of which the nearest cell points are not known.
IntervalGradient anywhere(Operands places, const Interval& value, const CrackleSettings& settings,
                          bool continuous) {
    const double steepness = settings.solid ? 0 : steepestCrackle(settings);
    if (!(steepness < unlimited)) {
        std::uint8_t axes = 0;
        for (const IntervalGradient* place : places) axes |= place->axes;
        return hazardous(value, axes, GradientHazard::steepEdge);
    }
    IntervalGradient result = within(steepness, places, value);
    if (!continuous) addJump(result);
    return result;
}

struct Box {
    std::array<double, 3> low, high;
};

/// What can be nearest in the box; false where nothing is known.
bool rank(const Box& box, const CrackleSettings& settings, std::size_t order, Ranking& ranking) {
    CrackleCube cube{};
    for (std::size_t k = 0; k < 3; ++k) {
        cube.center[k] = 0.5 * box.low[k] + 0.5 * box.high[k];
        // What they leave out of the box is far less than what candidates allow for.
        cube.reach = std::max(cube.reach, 0.5 * (box.high[k] - box.low[k]) - 1e-11);
    }
    const CrackleCandidates* found = crackleCandidates(cube, settings.metric, static_cast<int>(order));
    if (!found) return false;
    // The candidates are those of a larger cube.
    const CrackleCells cells = crackleCells(box.low, box.high);
    for (std::size_t i = 0; i < found->count; ++i) {
        const std::array<double, 3> point{found->x[i], found->y[i], found->z[i]};
        const CrackleSight sight = crackleSight(point, cells);
        if (!sight.ever) continue;
        Distance distance = distanceTo(point, box.low, box.high, settings);
        distance.always = sight.always;
        ranking.add(distance);
    }
    return ranking.finish();
}

IntervalGradient withForm(const Ranking& ranking, const CrackleSettings& settings, Operands places,
                          const Interval& value) {
    const SlopeRange unclipped = ranking.sum(settings.form);
    if (unclipped.high < 0 || unclipped.low > 1) return within(0, places, value);
    Slopes slope{};
    const double steepness = std::min(ranking.gather(settings.form, slope), steepestCrackle(settings));
    for (SlopeRange& range : slope) {
        range = meet(range, SlopeRange::within(steepness));
        if (unclipped.low < 0 || unclipped.high > 1) range = hull(range, {});
    }
    return ofThree(places, value, slope, steepness);
}

/// The `cells` pattern is constant within a cell.
IntervalGradient cellsOf(Operands places, const Interval& value, const Box& box) {
    IntervalGradient result = within(0, places, value);
    for (std::size_t k = 0; k < 3; ++k)
        if (std::floor(box.low[k]) != std::floor(box.high[k])) addJump(result);
    return result;
}

}  // namespace

IntervalGradient crackleOf(const CrackleSettings& settings, Operands places, const Interval& value) {
    std::uint8_t axes = 0;
    Box box{};
    bool known = true;
    for (std::size_t k = 0; k < 3; ++k) {
        const IntervalGradient& place = *places[k];
        axes |= place.axes;
        box.low[k] = place.value.low;
        box.high[k] = place.value.high;
        known = known && !place.value.empty() && !place.value.maybeUndefined && box.low[k] > -lastCell &&
                box.high[k] < lastCell;
    }
    if (axes == 0) return constant(value);
    // A power of an offset below 0 has no value.
    const bool hasValue = settings.metric > 0 && (settings.metric == 2 || settings.offset >= 0);
    if (!known || settings.table || !(hasValue || settings.cells))
        return hazardous(value, axes, GradientHazard::unknown);
    if (settings.cells) return cellsOf(places, value, box);
    const std::size_t order = orderOf(settings);
    const bool seesAll =
        crackleSeesEnough(crackleCells(box.low, box.high), settings.metric, static_cast<int>(order));
    Ranking ranking(order);
    if (!rank(box, settings, order, ranking))
        return anywhere(places, value, settings, seesAll && !settings.solid);
    if (ranking.hasCusp() && !settings.solid) return hazardous(value, axes, GradientHazard::steepEdge);
    IntervalGradient result =
        settings.solid ? within(0, places, value) : withForm(ranking, settings, places, value);
    const bool jumps = !seesAll && ranking.mayJump();
    if (jumps || (settings.solid && ranking.nearestCount() > 1)) addJump(result);
    return result;
}

}  // namespace isoscope::gradient_rules
