// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/certified/root_polish.h"

#include <algorithm>
#include <cmath>

#include "core/roots/certified/general_search.h"
#include "core/roots/certified/line_points.h"
#include "core/roots/certified/points_on_line.h"

namespace isoscope {

namespace {

/// How near a root is to be known, in parts of the accuracy or of the interval.
constexpr double remainder = 5e-5;
/// What a step with the enclosure's slope leaves is told for slopes that change evenly; those of blended
/// folds were seen to change three times as much near one end.
constexpr double unevenness = 4;
/// More secants than these are not tried.
constexpr int secants = 3;
/// A step has to leave no more than this part of the value, or there may be a kink.
constexpr double smoothStep = 0.1;

/// A smooth function needs two or three steps, a kink some more.
constexpr int polishSteps = 8;
constexpr double polished = 1e-4;

/// A product of tiny values could be 0.
bool areOpposite(double a, double b) { return (a < 0 && b > 0) || (a > 0 && b < 0); }

}  // namespace

/// One crossing that is narrowed down by false position (the Illinois variant).
struct RootPolish::Bracket {
    double low, high;
    double valueLow = 0, valueHigh = 0;
    double t = 0;
    int kept = 0;       ///< which end was kept in the last step: -1 low, 1 high
    double before = 0;  ///< the lesser of the absolute values at the ends, to begin with
    double last = 0;    ///< absolute value in the last step

    /// The steps have not come near 0: the function has no slope here, or hardly any.
    bool jumps() const { return usable() && last > 0.5 * before; }
    bool settled() const { return !usable() || last <= polished * before; }
    bool usable() const { return areOpposite(valueLow, valueHigh); }
    void begin(double value) {
        valueHigh = value;
        before = std::min(std::abs(valueLow), std::abs(value));
    }
    void choose() {
        t = usable() ? low - valueLow * ((high - low) / (valueHigh - valueLow)) : low + (high - low) / 2;
        if (!(t >= low && t <= high)) t = low + (high - low) / 2;
    }
    void supply(double value) {
        last = std::abs(value);
        if (!usable() || std::isnan(value)) return;
        if (value == 0) {
            low = high = t;
            valueLow = valueHigh = 0;
        } else if (!areOpposite(value, valueLow)) {
            low = t;
            valueLow = value;
            if (kept == 1) valueHigh /= 2;
            kept = 1;
        } else {
            high = t;
            valueHigh = value;
            if (kept == -1) valueLow /= 2;
            kept = -1;
        }
    }
};

void RootPolish::run(std::span<const RoughRoot> rough, std::span<const LineQuery> queries,
                     std::span<RootList> roots, const SimplifiedTape* simplifiedTape) {
    simplifiedTape_ = simplifiedTape;
    unsettled_.clear();
    for (std::size_t first = 0; first < rough.size(); first += batchLanes)
        polishSmooth(rough.subspan(first, std::min(batchLanes, rough.size() - first)), queries, roots);
    const std::span<const RoughRoot> left(unsettled_);
    for (std::size_t first = 0; first < left.size(); first += batchLanes)
        narrow(left.subspan(first, std::min(batchLanes, left.size() - first)), queries, roots);
}

void RootPolish::load(std::size_t k, const RoughRoot& rough, std::span<const LineQuery> queries) {
    const LineQuery& query = queries[rough.line];
    for (std::size_t c = 0; c < 3; ++c) {
        origin_[c][k] = query.origin[static_cast<int>(c)];
        direction_[c][k] = query.direction[static_cast<int>(c)];
    }
}

void RootPolish::evaluate(std::size_t count, const Lanes& t, Lanes& values) {
    // A fixed number of lanes: vector instructions.
    for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t k = 0; k < batchLanes; ++k) place_[c][k] = origin_[c][k] + t[k] * direction_[c][k];
    const auto x = std::span(place_[0]).first(count), y = std::span(place_[1]).first(count);
    const auto z = std::span(place_[2]).first(count), out = std::span(values).first(count);
    if (simplifiedTape_ != nullptr)
        points_.evaluate(x, y, z, out, *simplifiedTape_);
    else
        points_.evaluate(x, y, z, out);
    for (std::size_t k = 0; k < count; ++k) values[k] = settings_.signedValue(values[k]);
}

/// One step of Newton's with the slope of the enclosure; secants for those that are bent.
void RootPolish::polishSmooth(std::span<const RoughRoot> group, std::span<const LineQuery> queries,
                              std::span<RootList> roots) {
    Lanes t{}, values;
    for (std::size_t k = 0; k < group.size(); ++k) {
        load(k, group[k], queries);
        t[k] = group[k].low + (group[k].high - group[k].low) / 2;
    }
    evaluate(group.size(), t, values);
    bent_.clear();
    for (std::size_t k = 0; k < group.size(); ++k) {
        const RoughRoot& rough = group[k];
        const double next = t[k] - values[k] / rough.steepness;
        // What is steeper than its slope has a kink or a jump.
        const bool steady = std::abs(values[k]) <= std::abs(rough.steepness) * (rough.high - rough.low);
        if (!steady || !rough.holds(next))
            unsettled_.push_back(rough);
        else if (rough.leftover * unevenness <= remainder)
            roots[rough.line][rough.root].t = next;
        else
            bent_.push_back({rough, t[k], values[k], next});
    }
    for (int step = 0; step < secants && !bent_.empty(); ++step) secant(queries, roots);
    for (const Approach& left : bent_) unsettled_.push_back(left.rough);
}

/// One step for those that are bent. Those that settle, or will not, leave the list.
void RootPolish::secant(std::span<const LineQuery> queries, std::span<RootList> roots) {
    Lanes t{}, values;
    for (std::size_t k = 0; k < bent_.size(); ++k) {
        load(k, bent_[k].rough, queries);
        t[k] = bent_[k].t;
    }
    evaluate(bent_.size(), t, values);
    std::size_t left = 0;
    for (std::size_t k = 0; k < bent_.size(); ++k) {
        const Approach& at = bent_[k];
        const RoughRoot& rough = at.rough;
        const double way = at.t - at.before;
        const double next = values[k] == 0 ? at.t : at.t - values[k] * (way / (values[k] - at.valueBefore));
        const double part = std::abs(values[k] / at.valueBefore);
        if (values[k] != 0 && !(part <= smoothStep && rough.holds(next)))
            unsettled_.push_back(rough);
        else if (values[k] == 0 || part * part * std::abs(way) <= remainder * (rough.high - rough.low))
            roots[rough.line][rough.root].t = next;
        else
            bent_[left++] = {rough, at.t, values[k], next};
    }
    bent_.resize(left);
}

void RootPolish::narrow(std::span<const RoughRoot> group, std::span<const LineQuery> queries,
                        std::span<RootList> roots) {
    std::array<Bracket, batchLanes> brackets;
    std::array<std::size_t, batchLanes> open;
    std::size_t count = group.size();
    // take(bracket, value at parameterOf(bracket)) for the open ones
    const auto evaluateOpen = [&](auto parameterOf, auto take) {
        LinePoints(points_, settings_, simplifiedTape_)
            .evaluate(
                count, [&](std::size_t k) -> const LineQuery& { return queries[group[open[k]].line]; },
                [&](std::size_t k) { return parameterOf(brackets[open[k]]); },
                [&](std::size_t k, double value) { take(brackets[open[k]], value); });
    };
    for (std::size_t k = 0; k < count; ++k) {
        brackets[k] = {group[k].low, group[k].high};
        open[k] = k;
    }
    evaluateOpen([](const Bracket& bracket) { return bracket.low; },
                 [](Bracket& bracket, double value) { bracket.valueLow = value; });
    evaluateOpen([](const Bracket& bracket) { return bracket.high; },
                 [](Bracket& bracket, double value) { bracket.begin(value); });
    for (int step = 0; step < polishSteps && count > 0; ++step) {
        for (std::size_t k = 0; k < count; ++k) brackets[open[k]].choose();
        evaluateOpen([](const Bracket& bracket) { return bracket.t; },
                     [](Bracket& bracket, double value) { bracket.supply(value); });
        const auto settled = [&](std::size_t bracket) { return brackets[bracket].settled(); };
        count = static_cast<std::size_t>(std::remove_if(open.begin(), open.begin() + count, settled) -
                                         open.begin());
    }
    for (std::size_t k = 0; k < group.size(); ++k) settle(brackets[k], group[k], queries, roots);
}

void RootPolish::settle(Bracket& bracket, const RoughRoot& rough, std::span<const LineQuery> queries,
                        std::span<RootList> roots) {
    bracket.choose();
    Root& root = roots[rough.line][rough.root];
    root.t = bracket.t;
    if (!bracket.jumps()) return;
    PointsOnLine line(points_, settings_, queries[rough.line]);
    const int sign = bracket.valueLow > 0 ? 1 : -1;
    const auto found = locateSignChange(sign, rough.low, rough.high, line);
    if (found && found->root.kind != RootKind::pole) root = found->root;
}

}  // namespace isoscope
