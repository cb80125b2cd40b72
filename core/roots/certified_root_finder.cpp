// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/certified_root_finder.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace isoscope {

namespace {

/// The signed function on many lines: take(k, value) for k from 0 to count - 1, at parameterOf(k) on
/// lineOf(k).
template <class LineOf, class ParameterOf, class Take>
void evaluateOnLines(BatchEvaluator& evaluator, const RootSettings& settings, std::size_t count,
                     LineOf lineOf, ParameterOf parameterOf, Take take) {
    std::array<double, batchLanes> x, y, z, values;
    for (std::size_t first = 0; first < count; first += batchLanes) {
        const std::size_t lanes = std::min(batchLanes, count - first);
        for (std::size_t i = 0; i < lanes; ++i) {
            const LineQuery& query = lineOf(first + i);
            const glm::dvec3 p = query.origin + parameterOf(first + i) * query.direction;
            x[i] = p.x, y[i] = p.y, z[i] = p.z;
        }
        const auto column = [lanes](std::array<double, batchLanes>& a) { return std::span(a).first(lanes); };
        evaluator.evaluate(column(x), column(y), column(z), column(values));
        for (std::size_t i = 0; i < lanes; ++i) take(first + i, settings.signedValue(values[i]));
    }
}

bool isSearchable(const LineQuery& query) { return query.near < query.far && std::isfinite(query.far); }

/// A smooth function needs two or three steps, a kink some more.
constexpr int polishSteps = 8;
constexpr double polished = 1e-4;

}  // namespace

/// One crossing that is narrowed down by false position (the Illinois variant).
struct CertifiedRootFinder::Bracket {
    double low, high;
    double valueLow = 0, valueHigh = 0;
    double t = 0;
    int kept = 0;       ///< which end was kept in the last step: -1 low, 1 high
    double before = 0;  ///< the lesser of the absolute values at the ends, to begin with
    double last = 0;    ///< absolute value in the last step

    /// The steps have not come near 0: the function has no slope here, or hardly any.
    bool jumps() const { return usable() && last > 0.5 * before; }
    bool settled() const { return !usable() || last <= polished * before; }
    bool usable() const { return valueLow * valueHigh < 0; }
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
        } else if (value * valueLow > 0) {
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

CertifiedRootFinder::CertifiedRootFinder(std::shared_ptr<const Tape> tape, std::span<const double> parameters,
                                         const RootSettings& settings, std::uint32_t budget)
    : settings_(settings.usable()),
      forms_(tape, parameters),
      points_(tape, parameters),
      gradients_(tape, parameters),
      tape_(tape),
      lanes_({settings_, forms_, points_, budget}),
      slabs_(*tape_, {settings_, forms_, points_, budget}) {}

void CertifiedRootFinder::find(std::span<const LineQuery> queries, const RootRequest& request,
                               std::span<RootList> roots) {
    for (RootList& list : roots) list.clear();
    verdicts_.assign(queries.size(), Verdict::certifiedMiss);
    ends_.assign(queries.size(), EndSign::unknown);
    wanted_.resize(queries.size());
    for (std::size_t i = 0; i < queries.size(); ++i) wanted_[i] = isSearchable(queries[i]);
    pending_.clear();
    if (!settings_.open) addEntryWalls(queries, request, roots);
    search(queries, request, roots);
    if (request.stop.stop_requested()) {
        for (RootList& list : roots) list.clear();
        return;
    }
    polish(queries, roots);
    if (!settings_.open) addExitWalls(queries, request, roots);
}

void CertifiedRootFinder::search(std::span<const LineQuery> queries, const RootRequest& request,
                                 std::span<RootList> roots) {
    const bool many = queries.size() >= BundleMarch::bundleLines;
    if (!many || !slabs_.worthwhile()) return searchLines(queries, 0, queries.size(), request, roots);
    for (std::size_t first = 0; first < queries.size() && !request.stop.stop_requested();
         first += SlabSearch::batchLines) {
        if (!slabs_.begin(queries, wanted_, first)) {
            searchLines(queries, first, std::min(first + SlabSearch::batchLines, queries.size()), request,
                        roots);
            continue;
        }
        slabs_.run(
            queries, wanted_, request.sufficient, request.stop,
            [&](std::size_t line, const CertifiedSearch& search, double endSign) {
                retire(line, search, endSign, roots);
            },
            [&](std::size_t line, double sign) { miss(line, sign); });
    }
}

/// Searches the lines [first, end) with the whole tape.
void CertifiedRootFinder::searchLines(std::span<const LineQuery> queries, std::size_t first, std::size_t end,
                                      const RootRequest& request, std::span<RootList> roots) {
    starts_.assign(end - first, {});
    if (end - first >= BundleMarch::bundleLines)
        bundles_.run(queries.subspan(first, end - first), std::span(wanted_).subspan(first, end - first),
                     {settings_.threshold, settings_.positivePolarity}, forms_, starts_);
    lanes_.clear();
    for (std::size_t next = first; (next < end || !lanes_.empty()) && !request.stop.stop_requested();) {
        for (; next < end && !lanes_.full(); ++next) {
            if (!wanted_[next]) continue;
            const CertainStart& start = starts_[next - first];
            if (start.sign != 0 && start.start >= queries[next].far)
                miss(next, start.sign);
            else
                lanes_.add(next, queries[next], request.sufficient, start);
        }
        if (lanes_.empty()) continue;
        lanes_.step(queries, nullptr, [&](std::size_t line, const CertifiedSearch& search, double endSign) {
            retire(line, search, endSign, roots);
        });
    }
}

/// The function is known to have one sign all along the line.
void CertifiedRootFinder::miss(std::size_t line, double sign) {
    ++searches_;
    if (!forms_.certain()) verdicts_[line] = Verdict::notCertified;
    noteEnd(line, sign);
}

void CertifiedRootFinder::retire(std::size_t line, const CertifiedSearch& search, double endSign,
                                 std::span<RootList> roots) {
    ++searches_;
    verdicts_[line] = search.verdict();
    exhausted_ += search.verdict() == Verdict::budgetExceeded;
    noteEnd(line, endSign);
    for (const BracketedRoot& found : search.roots()) {
        if (found.refinable) pending_.push_back({line, roots[line].size(), found.low, found.high});
        roots[line].push_back(found.root);
    }
}

void CertifiedRootFinder::noteEnd(std::size_t line, double sign) {
    if (sign != 0) ends_[line] = sign < 0 ? EndSign::inside : EndSign::outside;
}

/// Lines that come from outside into the solid meet its wall at once.
void CertifiedRootFinder::addEntryWalls(std::span<const LineQuery> queries, const RootRequest& request,
                                        std::span<RootList> roots) {
    asked_.clear();
    for (std::size_t i = 0; i < queries.size(); ++i)
        if (queries[i].near > 0 && wanted_[i]) asked_.push_back(i);
    evaluateOnLines(
        points_, settings_, asked_.size(),
        [&](std::size_t k) -> const LineQuery& { return queries[asked_[k]]; },
        [&](std::size_t k) { return queries[asked_[k]].near; },
        [&](std::size_t k, double value) {
            if (!(value < 0)) return;
            const std::size_t i = asked_[k];
            roots[i].push_back({queries[i].near, RootKind::entryWall});
            wanted_[i] = queries[i].near < request.sufficient;
            if (!wanted_[i]) verdicts_[i] = forms_.certain() ? Verdict::certifiedHit : Verdict::notCertified;
        });
}

void CertifiedRootFinder::addExitWalls(std::span<const LineQuery> queries, const RootRequest& request,
                                       std::span<RootList> roots) {
    asked_.clear();
    for (std::size_t i = 0; i < queries.size(); ++i) {
        const bool satisfied = !roots[i].empty() && roots[i].back().t >= request.sufficient;
        if (satisfied || !isSearchable(queries[i]) || ends_[i] == EndSign::outside) continue;
        if (ends_[i] == EndSign::inside)
            roots[i].push_back({queries[i].far, RootKind::exitWall});
        else
            asked_.push_back(i);
    }
    evaluateOnLines(
        points_, settings_, asked_.size(),
        [&](std::size_t k) -> const LineQuery& { return queries[asked_[k]]; },
        [&](std::size_t k) { return queries[asked_[k]].far; },
        [&](std::size_t k, double value) {
            if (value < 0) roots[asked_[k]].push_back({queries[asked_[k]].far, RootKind::exitWall});
        });
}

void CertifiedRootFinder::polish(std::span<const LineQuery> queries, std::span<RootList> roots) {
    const std::span<const Pending> all(pending_);
    for (std::size_t first = 0; first < all.size(); first += batchLanes)
        polishGroup(all.subspan(first, std::min(batchLanes, all.size() - first)), queries, roots);
}

void CertifiedRootFinder::polishGroup(std::span<const Pending> group, std::span<const LineQuery> queries,
                                      std::span<RootList> roots) {
    std::array<Bracket, batchLanes> brackets;
    std::array<std::size_t, batchLanes> open;
    std::size_t count = group.size();
    // take(bracket, value at parameterOf(bracket)) for the open ones
    const auto evaluateOpen = [&](auto parameterOf, auto take) {
        evaluateOnLines(
            points_, settings_, count,
            [&](std::size_t k) -> const LineQuery& { return queries[group[open[k]].query]; },
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

void CertifiedRootFinder::settle(Bracket& bracket, const Pending& pending, std::span<const LineQuery> queries,
                                 std::span<RootList> roots) {
    bracket.choose();
    Root& root = roots[pending.query][pending.root];
    root.t = bracket.t;
    if (!bracket.jumps()) return;
    PointsOnLine line(points_, settings_, queries[pending.query]);
    const int sign = bracket.valueLow > 0 ? 1 : -1;
    if (const auto found = locateSignChange(sign, pending.low, pending.high, line)) root = found->root;
}

void CertifiedRootFinder::normals(std::span<const glm::dvec3> points, std::span<glm::dvec3> out) {
    const double outward = settings_.positivePolarity ? -1 : 1;
    std::array<double, batchLanes> x, y, z;
    std::array<ValueAndGradient, batchLanes> gradients;
    for (std::size_t first = 0; first < points.size(); first += batchLanes) {
        const std::size_t count = std::min(batchLanes, points.size() - first);
        for (std::size_t k = 0; k < count; ++k) {
            const glm::dvec3& p = points[first + k];
            x[k] = p.x, y[k] = p.y, z[k] = p.z;
        }
        gradients_.evaluate(std::span(x).first(count), std::span(y).first(count), std::span(z).first(count),
                            std::span(gradients).first(count));
        for (std::size_t k = 0; k < count; ++k) {
            const auto& [dx, dy, dz] = gradients[k].gradient;
            const bool vanishes = dx == 0 && dy == 0 && dz == 0;
            out[first + k] = outward * (vanishes ? difference(points[first + k]) : glm::dvec3(dx, dy, dz));
        }
    }
}

glm::dvec3 CertifiedRootFinder::difference(const glm::dvec3& point) {
    glm::dvec3 result{0};
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 low = point, high = point;
        low[axis] -= settings_.accuracy;
        high[axis] += settings_.accuracy;
        const double rise = value(high) - value(low);
        if (std::isfinite(rise)) result[axis] = rise;
    }
    return result;
}

RootFinderReport CertifiedRootFinder::report() const {
    RootFinderReport report;
    report.maxGradient = settings_.maxGradient;
    report.searches = searches_;
    report.evaluations = forms_.evaluations() + points_.evaluations();
    report.exhausted = exhausted_;
    return report;
}

}  // namespace isoscope
