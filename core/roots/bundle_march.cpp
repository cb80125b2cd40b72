// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/bundle_march.h"

#include <algorithm>

#include "core/roots/line_bundle.h"
namespace isoscope {

namespace {

/// More enclosures of a bundle are better spent on its lines.
constexpr double bundleBudget = 30;
/// A bundle is not followed into pieces shorter than this part of its length.
constexpr double shortestPart = 1.0 / 64;

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
            std::fill_n(starts.begin() + static_cast<std::ptrdiff_t>(lines_[k].first), lines_[k].count,
                        results_[k]);
    }
}

/// Puts a bundle into lane active_, unless it has no line.
bool BundleMarch::admit(const Lines& lines, std::span<const LineQuery> queries,
                        std::span<const std::uint8_t> wanted) {
    const auto bundle = LineBundle::around(queries.subspan(lines.first, lines.count),
                                           wanted.subspan(lines.first, lines.count));
    if (!bundle) return false;
    const std::size_t lane = active_;
    const double near = bundle->near, far = bundle->far;
    bundle->place(lane, pieces_, spread_);
    pieces_.start[lane] = near;
    pieces_.length[lane] = (far - near) / 2;
    lanes_.far[lane] = far;
    lanes_.resolution[lane] = lanes_.tolerance[lane] = std::max(bundle->width(), shortestPart * (far - near));
    lanes_.sign[lane] = lanes_.watched[lane] = lanes_.noise[lane] = lanes_.evaluations[lane] = 0;
    lanes_.signPlace[lane] = near;
    lanes_.budget[lane] = bundleBudget;
    lines_[lane] = lines;
    bundleOf_[lane] = lane;
    results_[lane] = {};
    return true;
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
