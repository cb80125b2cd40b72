// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/lipschitz/lipschitz_root_finder.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/roots/povray_normal.h"

namespace isoscope {

LipschitzRootFinder::LipschitzRootFinder(std::unique_ptr<FieldFunction> field, const RootSettings& settings)
    : field_(std::move(field)), settings_(settings.usable()), lanes_(settings_) {}

void LipschitzRootFinder::find(std::span<const LineQuery> queries, const RootRequest& request,
                               std::span<RootList> roots) {
    for (RootList& list : roots) list.clear();
    queries_ = queries;
    roots_ = roots;
    // Lines that a stop request keeps from their turn leave an empty trail.
    trails_.assign(queries.size(), {});
    remembers_ = request.missMemory;
    sufficient_ = request.sufficient;
    active_ = nextLine_ = 0;
    step_ = 0;
    nextBudgetCheck_ = LipschitzSearch::evaluationLimit + 1;
    lanes_.drop(lanes_.halving());
    // With `evaluate` each line needs what the line before it has learnt.
    const std::size_t lanes = settings_.evaluate ? 1 : LipschitzLanes::limit;

    while (active_ < lanes && admit(active_)) ++active_;
    while (active_ > 0 && !request.stop.stop_requested()) {
        evaluateLanes();
        advance();
    }
    for (std::size_t lane = 0; lane < active_; ++lane) {
        roots_[lineOf_[lane]].clear();
        trails_[lineOf_[lane]] = {};
    }
    if (remembers_ && !settings_.evaluate)
        for (std::size_t line = 0; line < trails_.size(); ++line)
            missMemory_.apply(queries[line], trails_[line], lanes_.memory().bound, roots[line]);
}

/// Starts the next line that has anything to search on `lane`; false when there is none.
bool LipschitzRootFinder::admit(std::size_t lane) {
    while (nextLine_ < queries_.size()) {
        const std::size_t line = nextLine_++;
        const LineQuery& query = queries_[line];
        if (query.near <= query.far) ++report_.searches;
        boundBefore_ = lanes_.memory().bound;
        LipschitzSearch& search = searches_[lane];
        search.begin(query, settings_, sufficient_, lanes_.memory(), roots_[line], trails_[line]);
        if (search.done()) continue;
        lineOf_[lane] = line;
        begunAt_[lane] = step_;
        lanes_.place(lane, query);
        lanes_.ask(lane, search.wanted());
        return true;
    }
    return false;
}

void LipschitzRootFinder::evaluateLanes() {
    lanes_.computePoints(active_);
    field_->values(lanes_.points(0, active_), lanes_.points(1, active_), lanes_.points(2, active_),
                   std::span(values_).first(active_));
    report_.evaluations += active_;
    ++step_;
}

void LipschitzRootFinder::advance() {
    const std::uint64_t inUse = ~std::uint64_t{0} >> (LipschitzLanes::limit - active_);
    const std::uint64_t asked = inUse & ~lanes_.halving();
    const std::uint64_t overdue = step_ >= nextBudgetCheck_ ? overdueLanes() : 0;
    lanes_.drop(overdue);
    const std::uint64_t ended = lanes_.advance(std::span(values_).first(active_));
    // From the last lane down: the lane that takes the place of a removed one has had its turn.
    forEachLane(asked | ended | overdue, [&](std::size_t lane) {
        const std::uint64_t bit = std::uint64_t{1} << lane;
        LipschitzSearch& search = searches_[lane];
        if ((overdue & bit) != 0) {
            search.giveUp();
            ++report_.exhausted;
        } else if ((asked & bit) != 0) {
            search.supply(values_[lane]);
        } else {
            search.halved(lanes_.result(lane));
        }
        follow(lane);
    });
}

/// Lanes whose line has had more than its share of values.
std::uint64_t LipschitzRootFinder::overdueLanes() {
    constexpr std::uint64_t limit = LipschitzSearch::evaluationLimit;
    std::uint64_t overdue = 0;
    nextBudgetCheck_ = step_ + limit;
    for (std::size_t lane = 0; lane < active_; ++lane) {
        if (step_ - begunAt_[lane] > limit)
            overdue |= std::uint64_t{1} << lane;
        else
            nextBudgetCheck_ = std::min(nextBudgetCheck_, begunAt_[lane] + limit + 1);
    }
    return overdue;
}

/// Gives the lane what its search wants next, or another line.
void LipschitzRootFinder::follow(std::size_t lane) {
    LipschitzSearch& search = searches_[lane];
    while (search.halving())
        if (lanes_.start(lane, search.interval()))
            return;
        else
            search.halved(lanes_.result(lane));
    if (!search.done()) return lanes_.ask(lane, search.wanted());
    retire(lane);
    if (!admit(lane)) remove(lane);
}

void LipschitzRootFinder::retire(std::size_t lane) {
    if (!remembers_ || !settings_.evaluate) return;
    // A dismissed line teaches nothing about the gradient.
    const std::size_t line = lineOf_[lane];
    if (missMemory_.apply(queries_[line], trails_[line], boundBefore_, roots_[line]))
        lanes_.memory().bound = boundBefore_;
}

void LipschitzRootFinder::remove(std::size_t lane) {
    --active_;
    if (lane == active_) return;
    searches_[lane] = searches_[active_];
    lineOf_[lane] = lineOf_[active_];
    begunAt_[lane] = begunAt_[active_];
    lanes_.move(active_, lane);
}

void LipschitzRootFinder::normals(std::span<const glm::dvec3> points, std::span<glm::dvec3> out) {
    povrayNormals<LipschitzLanes::limit>(
        points, settings_,
        [&](auto x, auto y, auto z, std::span<double> values) {
            field_->values(x, y, z, values);
            report_.evaluations += values.size();
        },
        out);
}

double LipschitzRootFinder::value(const glm::dvec3& point) {
    double result = 0;
    field_->values(std::span(&point.x, 1), std::span(&point.y, 1), std::span(&point.z, 1),
                   std::span(&result, 1));
    ++report_.evaluations;
    return result;
}

void LipschitzRootFinder::restart() {
    lanes_.memory() = {settings_.maxGradient, 0};
    missMemory_ = {};
    report_ = {};
}

RootFinderReport LipschitzRootFinder::report() const {
    RootFinderReport result = report_;
    result.maxGradient = lanes_.memory().bound;
    result.steepest = lanes_.memory().steepest;
    return result;
}

}  // namespace isoscope
