// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/lipschitz_root_finder.h"

#include <algorithm>
#include <utility>

namespace isoscope {

LipschitzRootFinder::LipschitzRootFinder(std::unique_ptr<FieldFunction> field, const RootSettings& settings)
    : field_(std::move(field)), settings_(settings.usable()) {
    memory_.bound = settings_.maxGradient;
}

void LipschitzRootFinder::find(std::span<const LineQuery> queries, const RootRequest& request,
                               std::span<RootList> roots) {
    for (RootList& list : roots) list.clear();
    trails_.assign(request.missMemory ? queries.size() : 0, {});
    sufficient_ = request.sufficient;
    active_ = nextLine_ = 0;
    // With `evaluate` each line needs what the line before it has learnt.
    const std::size_t lanes = settings_.evaluate ? 1 : laneLimit;

    while (!request.stop.stop_requested()) {
        while (active_ < lanes && admit(active_, queries)) ++active_;
        if (active_ == 0) break;
        evaluateLanes(queries);
        advance(queries, roots);
    }
    if (!settings_.evaluate)
        for (std::size_t line = 0; line < trails_.size(); ++line)
            missMemory_.apply(queries[line], trails_[line], memory_.bound, roots[line]);
}

void LipschitzRootFinder::advance(std::span<const LineQuery> queries, std::span<RootList> roots) {
    for (std::size_t lane = 0; lane < active_;) {
        searches_[lane].supply(values_[lane]);
        if (searches_[lane].done()) {
            retire(lane, queries, roots);
            if (!admit(lane, queries)) {
                --active_;
                std::swap(searches_[lane], searches_[active_]);
                std::swap(lineOf_[lane], lineOf_[active_]);
                std::swap(values_[lane], values_[active_]);
                continue;
            }
        }
        ++lane;
    }
}

/// Starts the next line that has anything to search on `lane`; false when there is none.
bool LipschitzRootFinder::admit(std::size_t lane, std::span<const LineQuery> queries) {
    while (nextLine_ < queries.size()) {
        const std::size_t line = nextLine_++;
        if (queries[line].near <= queries[line].far) ++report_.searches;
        boundBefore_ = memory_.bound;
        searches_[lane].begin(queries[line], settings_, sufficient_, memory_);
        lineOf_[lane] = line;
        if (!searches_[lane].done()) return true;
    }
    return false;
}

void LipschitzRootFinder::evaluateLanes(std::span<const LineQuery> queries) {
    for (std::size_t lane = 0; lane < active_; ++lane) {
        const LineQuery& query = queries[lineOf_[lane]];
        const glm::dvec3 point = query.origin + searches_[lane].wanted() * query.direction;
        x_[lane] = point.x;
        y_[lane] = point.y;
        z_[lane] = point.z;
    }
    evaluate(active_);
}

void LipschitzRootFinder::evaluate(std::size_t count) {
    field_->values(std::span(x_).first(count), std::span(y_).first(count), std::span(z_).first(count),
                   std::span(values_).first(count));
    report_.evaluations += count;
}

void LipschitzRootFinder::normals(std::span<const glm::dvec3> points, std::span<glm::dvec3> out) {
    constexpr std::size_t pointsPerRun = laneLimit / 4;
    const double step = settings_.accuracy;
    for (std::size_t first = 0; first < points.size(); first += pointsPerRun) {
        const std::size_t count = std::min(pointsPerRun, points.size() - first);
        for (std::size_t k = 0; k < 4 * count; ++k) {
            glm::dvec3 point = points[first + k / 4];
            if (k % 4 != 0) point[static_cast<int>(k % 4) - 1] += step;
            x_[k] = point.x;
            y_[k] = point.y;
            z_[k] = point.z;
        }
        evaluate(4 * count);
        for (std::size_t k = 0; k < count; ++k) {
            const double here = settings_.signedValue(values_[4 * k]);
            for (int axis = 0; axis < 3; ++axis)
                out[first + k][axis] =
                    settings_.signedValue(values_[4 * k + 1 + static_cast<std::size_t>(axis)]) - here;
        }
    }
}

void LipschitzRootFinder::retire(std::size_t lane, std::span<const LineQuery> queries,
                                 std::span<RootList> roots) {
    const std::size_t line = lineOf_[lane];
    const LipschitzSearch& search = searches_[lane];
    roots[line] = search.roots();
    if (search.exhausted()) ++report_.exhausted;
    if (trails_.empty()) return;
    trails_[line] = search.trail();
    // A dismissed line teaches nothing about the gradient.
    if (settings_.evaluate && missMemory_.apply(queries[line], trails_[line], boundBefore_, roots[line]))
        memory_.bound = boundBefore_;
}

double LipschitzRootFinder::value(const glm::dvec3& point) {
    double result = 0;
    field_->values(std::span(&point.x, 1), std::span(&point.y, 1), std::span(&point.z, 1),
                   std::span(&result, 1));
    ++report_.evaluations;
    return result;
}

RootFinderReport LipschitzRootFinder::report() const {
    RootFinderReport result = report_;
    result.maxGradient = memory_.bound;
    result.steepest = memory_.steepest;
    return result;
}

}  // namespace isoscope
