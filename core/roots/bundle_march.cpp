// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/bundle_march.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace isoscope {

namespace {

/// More enclosures of a bundle are better spent on its lines.
constexpr double bundleBudget = 12;
/// A bundle is not followed into pieces shorter than this part of its length.
constexpr double shortestPart = 1.0 / 64;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A box as its middle and half widths, rounded outwards.
struct MiddleAndSpread {
    glm::dvec3 middle, spread;

    MiddleAndSpread(const glm::dvec3& low, const glm::dvec3& high)
        : middle(0.5 * (low + high)),
          spread((glm::max(high - middle, middle - low)) * (1 + 4 * std::numeric_limits<double>::epsilon())) {
    }
};

}  // namespace

void BundleMarch::run(std::span<const LineQuery> queries, std::span<const std::uint8_t> wanted,
                      const SignRule& rule, AffineEvaluator& forms, std::span<CertainStart> starts) {
    const std::size_t batchLines = batchLanes * bundleLines;
    for (std::size_t first = 0; first < queries.size(); first += batchLines) {
        active_ = 0;
        const std::size_t end = std::min(first + batchLines, queries.size());
        for (std::size_t line = first; line < end; line += bundleLines)
            if (admit({line, std::min(bundleLines, end - line)}, queries, wanted)) ++active_;
        const std::size_t count = active_;
        runBatch(rule, forms);
        for (std::size_t k = 0; k < count; ++k)
            std::fill_n(starts.begin() + static_cast<std::ptrdiff_t>(bundles_[k].first), bundles_[k].count,
                        results_[k]);
    }
}

/// Puts a bundle into lane active_, unless it has no line.
bool BundleMarch::admit(const Bundle& bundle, std::span<const LineQuery> queries,
                        std::span<const std::uint8_t> wanted) {
    glm::dvec3 lowOrigin(infinity), highOrigin(-infinity), lowDirection(infinity), highDirection(-infinity);
    double near = infinity, far = -infinity;
    for (std::size_t i = bundle.first; i < bundle.first + bundle.count; ++i) {
        if (!wanted[i]) continue;
        const LineQuery& query = queries[i];
        lowOrigin = glm::min(lowOrigin, query.origin), highOrigin = glm::max(highOrigin, query.origin);
        lowDirection = glm::min(lowDirection, query.direction);
        highDirection = glm::max(highDirection, query.direction);
        near = std::min(near, query.near), far = std::max(far, query.far);
    }
    if (!(near < far)) return false;
    const MiddleAndSpread origin(lowOrigin, highOrigin), direction(lowDirection, highDirection);
    const std::size_t lane = active_;
    for (int k = 0; k < 3; ++k) {
        pieces_.origin[k][lane] = origin.middle[k], spread_.origin[k][lane] = origin.spread[k];
        pieces_.direction[k][lane] = direction.middle[k], spread_.direction[k][lane] = direction.spread[k];
    }
    const double width = glm::length(origin.spread + far * direction.spread) / glm::length(direction.middle);
    const double resolution = std::max(width, shortestPart * (far - near));
    pieces_.start[lane] = near;
    pieces_.length[lane] = (far - near) / 2;
    lanes_.far[lane] = far;
    lanes_.resolution[lane] = lanes_.tolerance[lane] = resolution;
    lanes_.sign[lane] = lanes_.watched[lane] = lanes_.noise[lane] = lanes_.evaluations[lane] = 0;
    lanes_.signPlace[lane] = near;
    lanes_.budget[lane] = bundleBudget;
    bundles_[lane] = {bundle.first, bundle.count, near, far};
    bundleOf_[lane] = lane;
    results_[lane] = {};
    return std::isfinite(resolution);
}

void BundleMarch::runBatch(const SignRule& rule, AffineEvaluator& forms) {
    std::array<MarchEvent, batchLanes> events;
    while (active_ > 0) {
        if (!march(pieces_, lanes_, forms.evaluate(pieces_, active_, 0, &spread_), rule, active_,
                   events.data()))
            continue;
        for (std::size_t lane = active_; lane-- > 0;) {
            if (events[lane] == MarchEvent::none) continue;
            settle(lane);
            if (lane != --active_) move(active_, lane);
        }
    }
}

/// Any event ends the march: what comes now is for single lines to find out.
void BundleMarch::settle(std::size_t lane) {
    if (lanes_.sign[lane] == 0) return;
    results_[bundleOf_[lane]] = {lanes_.signPlace[lane], lanes_.sign[lane], pieces_.length[lane]};
}

void BundleMarch::move(std::size_t from, std::size_t to) {
    bundleOf_[to] = bundleOf_[from];
    pieces_.copyLane(from, to);
    lanes_.copyLane(from, to);
    for (std::size_t k = 0; k < 3; ++k) {
        spread_.origin[k][to] = spread_.origin[k][from];
        spread_.direction[k][to] = spread_.direction[k][from];
    }
}

}  // namespace isoscope
