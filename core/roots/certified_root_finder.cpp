// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/certified_root_finder.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace isoscope {

namespace {

/// The signed function along one line, one point at a time.
class PointsOnLine : public LineFunction {
  public:
    PointsOnLine(BatchEvaluator& evaluator, const RootSettings& settings, const LineQuery& query)
        : evaluator_(evaluator), settings_(settings), query_(query) {}

    double value(double t) override {
        const glm::dvec3 p = query_.origin + t * query_.direction;
        return settings_.signedValue(evaluator_.evaluate(p.x, p.y, p.z));
    }

  private:
    BatchEvaluator& evaluator_;
    const RootSettings& settings_;
    const LineQuery& query_;
};

constexpr int polishSteps = 2;

/// One crossing that is narrowed down by false position (the Illinois variant).
struct Bracket {
    double low, high;
    double valueLow = 0, valueHigh = 0;
    double t = 0;
    int kept = 0;  ///< which end was kept in the last step: -1 low, 1 high

    bool usable() const { return valueLow * valueHigh < 0; }
    void choose() {
        t = usable() ? low - valueLow * ((high - low) / (valueHigh - valueLow)) : low + (high - low) / 2;
        if (!(t >= low && t <= high)) t = low + (high - low) / 2;
    }
    void supply(double value) {
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

}  // namespace

CertifiedRootFinder::CertifiedRootFinder(std::shared_ptr<const Tape> tape, std::span<const double> parameters,
                                         const RootSettings& settings, std::uint32_t budget)
    : settings_(settings.usable()),
      budget_(budget),
      forms_(tape, parameters),
      points_(tape, parameters),
      gradients_(tape, parameters) {}

void CertifiedRootFinder::find(std::span<const LineQuery> queries, const RootRequest& request,
                               std::span<RootList> roots) {
    for (RootList& list : roots) list.clear();
    verdicts_.assign(queries.size(), Verdict::certifiedMiss);
    pending_.clear();
    active_ = 0;
    std::size_t next = 0;
    while ((active_ > 0 || next < queries.size()) && !request.stop.stop_requested()) {
        while (active_ < batchLanes && next < queries.size()) {
            lineOf_[active_] = next++;
            admit(active_, queries, request.sufficient);
        }
        if (active_ == 0) break;
        for (std::size_t lane = 0; lane < active_; ++lane) {
            pieces_.start[lane] = searchers_[lane].start();
            pieces_.length[lane] = searchers_[lane].length();
        }
        forms_.evaluate(pieces_, std::span(results_).first(active_));
        for (std::size_t lane = 0; lane < active_; ++lane) {
            PointsOnLine line(points_, settings_, queries[lineOf_[lane]]);
            searchers_[lane].supply(results_[lane], line);
        }
        for (std::size_t lane = active_; lane-- > 0;)
            if (searchers_[lane].done()) retire(lane, roots);
    }
    if (request.stop.stop_requested()) {
        for (RootList& list : roots) list.clear();
        return;
    }
    polish(queries, roots);
    if (!settings_.open) addWalls(queries, request, roots);
}

void CertifiedRootFinder::admit(std::size_t lane, std::span<const LineQuery> queries, double sufficient) {
    const LineQuery& query = queries[lineOf_[lane]];
    searchers_[lane].begin(query, settings_, sufficient, forms_.certain(), budget_);
    ++searches_;
    if (searchers_[lane].done()) return;
    place(lane, query);
    ++active_;
}

void CertifiedRootFinder::place(std::size_t lane, const LineQuery& query) {
    for (int k = 0; k < 3; ++k) {
        pieces_.origin[k][lane] = query.origin[k];
        pieces_.direction[k][lane] = query.direction[k];
    }
}

void CertifiedRootFinder::retire(std::size_t lane, std::span<RootList> roots) {
    const std::size_t query = lineOf_[lane];
    const CertifiedSearch& search = searchers_[lane];
    verdicts_[query] = search.verdict();
    exhausted_ += search.verdict() == Verdict::budgetExceeded;
    for (const BracketedRoot& found : search.roots()) {
        if (found.refinable) pending_.push_back({query, roots[query].size(), found.low, found.high});
        roots[query].push_back(found.root);
    }
    --active_;
    if (lane != active_) move(active_, lane);
}

void CertifiedRootFinder::move(std::size_t from, std::size_t to) {
    std::swap(searchers_[from], searchers_[to]);
    lineOf_[to] = lineOf_[from];
    for (int k = 0; k < 3; ++k) {
        pieces_.origin[k][to] = pieces_.origin[k][from];
        pieces_.direction[k][to] = pieces_.direction[k][from];
    }
}

void CertifiedRootFinder::polish(std::span<const LineQuery> queries, std::span<RootList> roots) {
    const std::span<const Pending> all(pending_);
    for (std::size_t first = 0; first < all.size(); first += batchLanes)
        polishGroup(all.subspan(first, std::min(batchLanes, all.size() - first)), queries, roots);
}

void CertifiedRootFinder::polishGroup(std::span<const Pending> group, std::span<const LineQuery> queries,
                                      std::span<RootList> roots) {
    std::array<Bracket, batchLanes> brackets;
    std::array<double, batchLanes> x, y, z, values;
    const std::size_t count = group.size();
    const auto evaluateAt = [&](auto parameterOf) {
        for (std::size_t k = 0; k < count; ++k) {
            const LineQuery& query = queries[group[k].query];
            const glm::dvec3 p = query.origin + parameterOf(brackets[k]) * query.direction;
            x[k] = p.x, y[k] = p.y, z[k] = p.z;
        }
        const auto column = [count](std::array<double, batchLanes>& a) { return std::span(a).first(count); };
        points_.evaluate(column(x), column(y), column(z), column(values));
        for (std::size_t k = 0; k < count; ++k) values[k] = settings_.signedValue(values[k]);
    };
    for (std::size_t k = 0; k < count; ++k) brackets[k] = {group[k].low, group[k].high};
    evaluateAt([](const Bracket& bracket) { return bracket.low; });
    for (std::size_t k = 0; k < count; ++k) brackets[k].valueLow = values[k];
    evaluateAt([](const Bracket& bracket) { return bracket.high; });
    for (std::size_t k = 0; k < count; ++k) brackets[k].valueHigh = values[k];
    for (int step = 0; step < polishSteps; ++step) {
        for (std::size_t k = 0; k < count; ++k) brackets[k].choose();
        evaluateAt([](const Bracket& bracket) { return bracket.t; });
        for (std::size_t k = 0; k < count; ++k) brackets[k].supply(values[k]);
    }
    for (std::size_t k = 0; k < count; ++k) {
        brackets[k].choose();
        roots[group[k].query][group[k].root].t = brackets[k].t;
    }
}

void CertifiedRootFinder::addWalls(std::span<const LineQuery> queries, const RootRequest& request,
                                   std::span<RootList> roots) {
    for (std::size_t i = 0; i < queries.size(); ++i) {
        const LineQuery& query = queries[i];
        if (!(query.near < query.far) || !std::isfinite(query.far)) continue;
        PointsOnLine line(points_, settings_, query);
        const bool entry = query.near > 0 && line.value(query.near) < 0;
        const bool satisfied = !roots[i].empty() && roots[i].back().t >= request.sufficient;
        const bool exit = !satisfied && line.value(query.far) < 0;
        if (entry) roots[i].insert(roots[i].begin(), {query.near, RootKind::entryWall});
        if (exit) roots[i].push_back({query.far, RootKind::exitWall});
    }
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
