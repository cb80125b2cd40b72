// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/certified/bundle_march.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isoscope {

namespace {

/// What this share of the errors amounts to need not be computed.
constexpr double worthlessShare = 0.1;
/// The next piece's part of the stretch where the lines of a bundle cross the surface (found by trial).
constexpr double crossingPart = 0.6;

/// Lines of a list, of which only those that are wanted count.
struct QueryBundles {
    std::span<const LineQuery> queries;
    std::span<const std::uint8_t> wanted;
    std::size_t offset;  ///< of the first one, among CertainStarts

    std::size_t size() const { return queries.size(); }
    bool isOpen(const LineRange&) const { return true; }
    void enclose(std::span<const LineRange> ranges, BundleLanes& bundles) const {
        bundles.enclose(queries, wanted, ranges);
    }
};

/// Lines in columns. With `starts`, only bundles of which no line is known to its end.
struct ColumnBundles {
    const LineColumns& lines;
    const CertainStarts* starts = nullptr;
    static constexpr std::size_t offset = 0;

    std::size_t size() const { return lines.count; }
    bool isOpen(const LineRange& range) const {
        return starts == nullptr || starts->open(lines, range.first, range.count);
    }
    void enclose(std::span<const LineRange> ranges, BundleLanes& bundles) const {
        bundles.enclose(lines, ranges);
    }
};

}  // namespace

void BundleMarch::run(std::span<const LineQuery> queries, std::span<const std::uint8_t> wanted,
                      const Rules& rules, AffineEvaluator& forms, CertainStarts& starts, std::size_t offset) {
    rules_ = rules;
    marched_ = nullptr;
    usualError_ = 0;
    const QueryBundles source{queries, wanted, offset};
    runWide(source, forms, starts);
    runNarrow(source, forms, starts);
}

void BundleMarch::run(const LineColumns& lines, const Rules& rules, AffineEvaluator& forms,
                      CertainStarts& starts, std::vector<MarchedBundle>* marched) {
    rules_ = rules;
    marched_ = marched;
    usualError_ = 0;
    // Nothing is certain yet.
    runWide(ColumnBundles{lines}, forms, starts);
    runNarrow(ColumnBundles{lines, &starts}, forms, starts);
}

void BundleMarch::refine(const LineColumns& lines, AffineEvaluator& forms, CertainStarts& starts,
                         std::vector<MarchedBundle>* marched) {
    if (!cost_.cheap) return;
    marched_ = marched;
    // Shorter pieces hardly help more lines than they cost (found by trial).
    runLevel({bundleLines, 30, 1.0 / 24}, ColumnBundles{lines, &starts}, forms, starts);
}

template <class Source>
void BundleMarch::runWide(const Source& source, AffineEvaluator& forms, CertainStarts& starts) {
    const std::size_t most = cost_.cheap ? 4 * bundleLines : bundleLines;
    runLevel({most, 30, 1.0 / 64}, source, forms, starts);
}

/// Where a step costs a lot, on behind runWide().
template <class Source>
void BundleMarch::runNarrow(const Source& source, AffineEvaluator& forms, CertainStarts& starts) {
    if (!cost_.holdsNoise) return;
    if (marched_ != nullptr) marched_->clear();
    // Where a step costs many noises, narrow bundles have to end sooner (found by trial).
    const Level narrow =
        cost_.isLong ? Level{bundleLines / 4, 8, 1.0 / 120} : Level{bundleLines / 4, 20, 1.0 / 300};
    runLevel(narrow, source, forms, starts);
}

template <class Source>
void BundleMarch::runLevel(const Level& level, const Source& source, AffineEvaluator& forms,
                           CertainStarts& starts) {
    for (std::size_t line = 0; line < source.size();) {
        std::size_t count = 0;
        for (; line < source.size() && count < batchLanes; line += level.lines) {
            lines_[count] = {line, std::min(level.lines, source.size() - line)};
            count += source.isOpen(lines_[count]);
        }
        source.enclose(std::span(lines_).first(count), bundles_);
        active_ = 0;
        for (std::size_t k = 0; k < count; ++k) admit(level, k, starts[source.offset + lines_[k].first]);
        runBatch(forms);
        if (marched_ != nullptr) noteMarched(count);
        for (std::size_t k = 0; k < count; ++k)
            if (results_[k].sign != 0)
                starts.set(source.offset + lines_[k].first, lines_[k].count, results_[k]);
    }
}

void BundleMarch::noteMarched(std::size_t bundles) {
    for (std::size_t k = 0; k < bundles; ++k)
        if (results_[k].sign > 0 && results_[k].start < bundles_.far[k])
            marched_->push_back({bundles_[k], lines_[k].first, lines_[k].count, results_[k]});
}

/// Puts a bundle into lane active_, unless it has no line, or none that goes on beyond what is certain.
void BundleMarch::admit(const Level& level, std::size_t bundle, const CertainStart& known) {
    results_[bundle] = {};
    if (rules_.insideEnds && known.sign < 0) return;
    const bool begun = known.sign != 0 && known.start > bundles_.near[bundle];
    const double near = begun ? known.start : bundles_.near[bundle], far = bundles_.far[bundle];
    if (!(near < far)) return;
    const std::size_t lane = active_++;
    bundles_.place(bundle, lane, pieces_, spread_);
    pieces_.start[lane] = near;
    pieces_.length[lane] = begun ? std::min(known.length, far - near) : (far - near) / 2;
    lanes_.far[lane] = far;
    lanes_.resolution[lane] = lanes_.tolerance[lane] =
        std::max(bundles_.width[bundle], level.shortestPart * (far - bundles_.near[bundle]));
    lanes_.sign[lane] = begun ? known.sign : 0;
    lanes_.watched[lane] = MarchLanes::noSign;
    lanes_.unresolvedError[lane] = lanes_.evaluations[lane] = 0;
    lanes_.signPlace[lane] = near;
    lanes_.budget[lane] = level.budget;
    bundleOf_[lane] = bundle;
}

void BundleMarch::runBatch(AffineEvaluator& forms) {
    std::array<MarchEvent, batchLanes> events;
    while (active_ > 0) {
        const AffineLanes found =
            forms.evaluate(pieces_.columns(), active_, worthlessShare * usualError_, &spread_);
        if (forms.hasApproximations()) noteErrors(found);
        const bool any = march(pieces_, lanes_, found, rules_.sign, active_, events.data());
        if (!any && !rules_.insideEnds) continue;
        for (std::size_t lane = active_; lane-- > 0;) {
            const bool inside = rules_.insideEnds && lanes_.sign[lane] < 0;
            if (events[lane] == MarchEvent::none && !inside) continue;
            settle(lane, events[lane]);
            if (lane != --active_) move(active_, lane);
        }
    }
}

/// The errors of bundles come from their width above all and change little from step to step.
void BundleMarch::noteErrors(const AffineLanes& found) {
    double sum = 0, count = 0;
    for (std::size_t lane = 0; lane < active_; ++lane) {
        if (!(std::abs(found.error[lane]) < std::numeric_limits<double>::infinity())) continue;
        sum += found.error[lane];
        ++count;
    }
    if (count > 0) usualError_ = sum / count;
}

/// Any event ends the march: what comes now is for single lines to find out.
void BundleMarch::settle(std::size_t lane, MarchEvent event) {
    if (lanes_.sign[lane] == 0) return;
    CertainStart& result = results_[bundleOf_[lane]];
    result = {lanes_.signPlace[lane], lanes_.sign[lane], pieces_.length[lane]};
    if (event != MarchEvent::crossing) return;
    // All lines change their sign between low and high, and not before.
    result.start = lanes_.low[lane];
    result.length = crossingPart * (lanes_.high[lane] - lanes_.low[lane]);
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
