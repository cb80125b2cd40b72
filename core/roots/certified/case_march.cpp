// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/certified/case_march.h"

#include <algorithm>

#include "core/roots/certified/form_sign.h"

namespace isoscope {

bool CaseMarch::step(AffineEvaluator& forms, RayPieces& pieces, MarchLanes& lanes, const SignRule& rule,
                     std::size_t count, MarchEvent* events) {
    cases_.bySides = false;
    const AffineLanes whole = forms.evaluateCases(pieces, count, cases_);
    const double* const columns[] = {whole.center, whole.slope, whole.error};
    for (std::size_t k = 0; k < 3; ++k) std::copy_n(columns[k], batchLanes, forms_[k].begin());
    collect(pieces, lanes, rule.threshold, count);
    if (pays())
        tryCases(forms, pieces, rule.threshold);
    else
        for (Undecided& at : undecided_) at.decided = false;
    const bool any =
        march(pieces, lanes, {forms_[0].data(), forms_[1].data(), forms_[2].data()}, rule, count, events);
    for (const Undecided& at : undecided_) {
        if (at.decided) continue;
        if (events[at.lane] == MarchEvent::none) shorten(at, pieces, lanes);
        const bool placed = at.last - at.first <= lanes.resolution[at.lane] / 64;
        if (events[at.lane] == MarchEvent::unresolved && placed) lanes.jump[at.lane] = at.last;
    }
    return any;
}

void CaseMarch::collect(const RayPieces& pieces, MarchLanes& lanes, double threshold, std::size_t count) {
    undecided_.clear();
    for (std::size_t i = 0; i < count; ++i) {
        if (!(cases_.jumps[i] > 0) ||
            formSign(forms_[0][i], forms_[1][i], forms_[2][i], {threshold, false}) != 0)
            continue;
        // An error that a jump makes is no rounding, however long it lasts.
        lanes.unresolvedError[i] = 0;
        const double t = pieces.start[i], half = pieces.length[i] / 2;
        const bool last = pieces.length[i] <= lanes.resolution[i];
        const double jumps = cases_.jumps[i];
        // Where one jump decides about others, there are fewer in each case than in all of them together.
        const int most = last && jumps <= mostJumpsAtLast ? mostJumpsAtLast : mostJumps;
        const bool few = last || jumps <= mostJumps;
        const auto cases = std::size_t(1) << std::min(static_cast<int>(jumps), most);
        undecided_.push_back({i, t, pieces.length[i], t + (1 + cases_.first[i]) * half,
                              t + (1 + cases_.last[i]) * half, few ? cases : 0, 0, few});
    }
}

void CaseMarch::tryCases(AffineEvaluator& forms, const RayPieces& pieces, double threshold) {
    cases_.bySides = true;
    std::size_t used = 0;
    for (std::size_t k = 0; k < undecided_.size(); ++k) {
        const Undecided& at = undecided_[k];
        if (used + at.cases > batchLanes) {
            runCases(forms, threshold, used);
            used = 0;
        }
        for (std::size_t side = 0; side < at.cases; ++side, ++used) {
            for (std::size_t c = 0; c < 3; ++c) {
                sidePieces_.origin[c][used] = pieces.origin[c][at.lane];
                sidePieces_.direction[c][used] = pieces.direction[c][at.lane];
            }
            sidePieces_.start[used] = at.start;
            sidePieces_.length[used] = at.length;
            cases_.sides[used] = static_cast<double>(side);
            owner_[used] = k;
        }
    }
    if (used > 0) runCases(forms, threshold, used);
    // One side of the threshold all along: any such form will do.
    for (const Undecided& at : undecided_) {
        tried_ += at.cases > 0;
        decided_ += at.decided;
        if (!at.decided) continue;
        forms_[0][at.lane] = threshold + at.sign;
        forms_[1][at.lane] = forms_[2][at.lane] = 0;
    }
}

void CaseMarch::runCases(AffineEvaluator& forms, double threshold, std::size_t count) {
    const AffineLanes sides = forms.evaluateCases(sidePieces_, count, cases_);
    for (std::size_t i = 0; i < count; ++i) {
        Undecided& at = undecided_[owner_[i]];
        const int sign = formSign(sides.center[i], sides.slope[i], sides.error[i], {threshold, false});
        const bool complete = std::size_t(1) << std::min(static_cast<int>(cases_.jumps[i]), 62) <= at.cases;
        at.decided = at.decided && complete && sign != 0 && (at.sign == 0 || at.sign == sign);
        at.sign = sign;
    }
}

/// Ends the piece right before the first jump; at the jump itself, right behind it.
void CaseMarch::shorten(const Undecided& at, RayPieces& pieces, MarchLanes& lanes) const {
    const double t = pieces.start[at.lane];
    // Forms are so good over so short a piece that the jump is known to a small part of it.
    const double finest = lanes.resolution[at.lane] / 64;
    const double rest = at.start + at.length - t;
    double& length = pieces.length[at.lane];
    const bool before = at.first - t > 2 * finest;
    const double wanted = before ? at.first - t - finest : std::max(at.last - t, finest) + finest;
    // A jump that may be anywhere tells nothing.
    if (!(wanted <= (before ? 0.9 : 0.5) * rest) || (before && wanted < length)) return;
    length = std::min(wanted, lanes.far[at.lane] - t);
    lanes.resumed[at.lane] = rest - wanted;
}

}  // namespace isoscope
