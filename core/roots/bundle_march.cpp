// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/bundle_march.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/roots/tape_cost.h"

namespace isoscope {

namespace {

/// What this share of the errors amounts to need not be computed.
constexpr double worthlessShare = 0.1;
/// The next piece's part of the stretch where the lines of a bundle cross the surface (found by trial).
constexpr double crossingPart = 0.55;

/// Makes bundles of lines of which none is known to its end.
auto aroundOpen(const LineColumns& lines, const CertainStarts& starts) {
    return [&](std::size_t first, std::size_t count) -> std::optional<LineBundle> {
        if (!starts.open(lines, first, count)) return {};
        return LineBundle::around(lines, first, count);
    };
}

}  // namespace

BundleMarch::BundleMarch(const Tape& tape)
    : costly_(holdsNoise(tape)),
      cheap_(isCheap(tape)),
      long_(!tape.loops().empty() || tape.instructions().size() > 40) {}

void BundleMarch::run(std::span<const LineQuery> queries, std::span<const std::uint8_t> wanted,
                      const Rules& rules, AffineEvaluator& forms, CertainStarts& starts, std::size_t offset) {
    rules_ = rules;
    marched_ = nullptr;
    usualError_ = 0;
    const auto around = [&](std::size_t first, std::size_t count) {
        return LineBundle::around(queries.subspan(first, count), wanted.subspan(first, count));
    };
    runWide(queries.size(), forms, starts, offset, around);
    runNarrow(queries.size(), forms, starts, offset, around);
}

void BundleMarch::run(const LineColumns& lines, const Rules& rules, AffineEvaluator& forms,
                      CertainStarts& starts, std::vector<MarchedBundle>* marched) {
    rules_ = rules;
    marched_ = marched;
    usualError_ = 0;
    // Nothing is certain yet.
    runWide(lines.count, forms, starts, 0,
            [&](std::size_t first, std::size_t count) { return LineBundle::around(lines, first, count); });
    runNarrow(lines.count, forms, starts, 0, aroundOpen(lines, starts));
}

void BundleMarch::refine(const LineColumns& lines, AffineEvaluator& forms, CertainStarts& starts,
                         std::vector<MarchedBundle>* marched) {
    if (!cheap_) return;
    marched_ = marched;
    // Shorter pieces hardly help more lines than they cost (found by trial).
    runLevel({bundleLines, 30, 1.0 / 24}, lines.count, forms, starts, 0, aroundOpen(lines, starts));
}

template <class Around>
void BundleMarch::runWide(std::size_t lines, AffineEvaluator& forms, CertainStarts& starts,
                          std::size_t offset, Around around) {
    const std::size_t most = cheap_ ? 4 * bundleLines : bundleLines;
    runLevel({most, 30, 1.0 / 64}, lines, forms, starts, offset, around);
}

/// Where a step costs a lot, on behind runWide().
template <class Around>
void BundleMarch::runNarrow(std::size_t lines, AffineEvaluator& forms, CertainStarts& starts,
                            std::size_t offset, Around around) {
    if (!costly_) return;
    if (marched_ != nullptr) marched_->clear();
    // Where a step costs many noises, narrow bundles have to end sooner (found by trial).
    const Level narrow = long_ ? Level{bundleLines / 4, 8, 1.0 / 100} : Level{bundleLines / 4, 20, 1.0 / 300};
    runLevel(narrow, lines, forms, starts, offset, around);
}

template <class Around>
void BundleMarch::runLevel(const Level& level, std::size_t count, AffineEvaluator& forms,
                           CertainStarts& starts, std::size_t offset, Around around) {
    for (std::size_t line = 0; line < count;) {
        active_ = 0;
        for (; line < count && active_ < batchLanes; line += level.lines) {
            const Lines lines{line, std::min(level.lines, count - line)};
            if (admit(level, lines, around(lines.first, lines.count), starts[offset + line])) ++active_;
        }
        const std::size_t bundles = active_;
        runBatch(forms);
        if (marched_ != nullptr) noteMarched(bundles);
        for (std::size_t k = 0; k < bundles; ++k)
            if (results_[k].sign != 0) starts.set(offset + lines_[k].first, lines_[k].count, results_[k]);
    }
}

void BundleMarch::noteMarched(std::size_t bundles) {
    for (std::size_t k = 0; k < bundles; ++k)
        if (results_[k].sign > 0 && results_[k].start < bundles_[k].far)
            marched_->push_back({bundles_[k], lines_[k].first, lines_[k].count, results_[k]});
}

/// Puts a bundle into lane active_, unless it has no line, or none that goes on beyond what is certain.
bool BundleMarch::admit(const Level& level, const Lines& lines, const std::optional<LineBundle>& bundle,
                        const CertainStart& known) {
    if (!bundle) return false;
    if (rules_.insideEnds && known.sign < 0) return false;
    const bool begun = known.sign != 0 && known.start > bundle->near;
    const double near = begun ? known.start : bundle->near, far = bundle->far;
    if (!(near < far)) return false;
    const std::size_t lane = active_;
    bundle->place(lane, pieces_, spread_);
    bundles_[lane] = *bundle;
    pieces_.start[lane] = near;
    pieces_.length[lane] = begun ? std::min(known.length, far - near) : (far - near) / 2;
    lanes_.far[lane] = far;
    lanes_.resolution[lane] = lanes_.tolerance[lane] =
        std::max(bundle->width, level.shortestPart * (far - bundle->near));
    lanes_.sign[lane] = begun ? known.sign : 0;
    lanes_.watched[lane] = MarchLanes::noSign;
    lanes_.noise[lane] = lanes_.evaluations[lane] = 0;
    lanes_.signPlace[lane] = near;
    lanes_.budget[lane] = level.budget;
    lines_[lane] = lines;
    bundleOf_[lane] = lane;
    results_[lane] = {};
    return true;
}

void BundleMarch::runBatch(AffineEvaluator& forms) {
    std::array<MarchEvent, batchLanes> events;
    while (active_ > 0) {
        const AffineLanes found =
            forms.evaluate(pieces_.columns(), active_, worthlessShare * usualError_, &spread_);
        if (forms.hasOutlines()) noteErrors(found);
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
