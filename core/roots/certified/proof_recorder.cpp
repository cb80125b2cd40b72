// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/certified/proof_recorder.h"

#include <algorithm>

namespace isoscope {

namespace {

ProofRule ruleOf(RootKind kind) {
    switch (kind) {
        case RootKind::jump: return ProofRule::jump;
        case RootKind::pole: return ProofRule::pole;
        default: return ProofRule::crossing;
    }
}

}  // namespace

const char* name(ProofRule rule) {
    switch (rule) {
        case ProofRule::form: return "form";
        case ProofRule::cases: return "cases";
        case ProofRule::undefined: return "undefined";
        case ProofRule::passed: return "passed";
        case ProofRule::sampled: return "sampled";
        case ProofRule::crossing: return "crossing";
        case ProofRule::jump: return "jump";
        case ProofRule::pole: return "pole";
    }
    return "";
}

void ProofRecorder::begin(const RayPieces& pieces, std::size_t count) {
    std::copy_n(pieces.start.begin(), count, start_.begin());
    std::copy_n(pieces.length.begin(), count, length_.begin());
}

void ProofRecorder::noteMarch(const RayPieces& pieces, const MarchLanes& lanes, const AffineLanes& forms,
                              std::span<const std::uint8_t> byCases, std::span<const MarchEvent> events) {
    for (std::size_t lane = 0; lane < events.size(); ++lane) {
        center_[lane] = forms.center[lane];
        slope_[lane] = forms.slope[lane];
        error_[lane] = forms.error[lane];
        byCases_[lane] = !byCases.empty() && byCases[lane] != 0;
        sign_[lane] = lanes.sign[lane];
        signPlace_[lane] = lanes.signPlace[lane];
        watched_[lane] = lanes.watched[lane];
        // As the search has it: a piece that is as long as the rest ends with the line, whatever the sum is.
        const bool through = length_[lane] >= lanes.far[lane] - start_[lane];
        end_[lane] = through ? lanes.far[lane] : start_[lane] + length_[lane];
        const double from = start_[lane];
        settled_[lane] = from;
        switch (events[lane]) {
            case MarchEvent::none:
            case MarchEvent::reachedEnd:
            case MarchEvent::exhausted: settled_[lane] = pieces.start[lane]; break;
            case MarchEvent::crossing:
            case MarchEvent::jump: settled_[lane] = lanes.low[lane]; break;
            case MarchEvent::unresolved: settled_[lane] = std::max(from, lanes.signPlace[lane]); break;
            case MarchEvent::bracket:
            case MarchEvent::newSign:
            case MarchEvent::undefined: break;
        }
        addClear(lane, from, settled_[lane], sign_[lane]);
    }
}

void ProofRecorder::noteHandled(const GeneralSearch& search, const GeneralSearch::Lane& lane,
                                MarchEvent event, std::size_t rootsBefore) {
    const std::size_t i = lane.index;
    const double settled = settled_[i], now = lane.start();
    if (search.done() && search.verdict() == Verdict::budgetExceeded)
        steps_.push_back({ProofRule::sampled, settled, lane[&MarchLanes::far]});
    if (event == MarchEvent::undefined)
        steps_.push_back({ProofRule::undefined, settled, now});
    else if (event == MarchEvent::unresolved && now > settled)
        steps_.push_back({ProofRule::passed, settled, now});
    addRoots(i, lane.lanes, now, event, std::span(search.roots()).subspan(rootsBefore));
    if (event == MarchEvent::crossing) addClear(i, lane[&MarchLanes::high], end_[i], -sign_[i]);
}

void ProofRecorder::addClear(std::size_t lane, double from, double to, double sign) {
    if (!(from < to)) return;
    ProofStep step{byCases_[lane] != 0 ? ProofRule::cases : ProofRule::form, from, to,
                   static_cast<int>(sign)};
    if (step.rule == ProofRule::form) {
        step.start = start_[lane], step.length = length_[lane];
        step.center = center_[lane], step.slope = slope_[lane], step.error = error_[lane];
    }
    steps_.push_back(step);
}

/// GeneralSearch narrows some roots down by computed values: what is certain of them is wider, if there is
/// anything.
void ProofRecorder::addRoots(std::size_t lane, const MarchLanes& lanes, double start, MarchEvent event,
                             std::span<const BracketedRoot> roots) {
    const bool sampled = watched_[lane] == MarchLanes::anySign;
    for (const BracketedRoot& found : roots) {
        ProofStep step{ruleOf(found.root.kind), found.low, found.high, 0};
        const bool flip = event == MarchEvent::newSign && !sampled && sign_[lane] != 0;
        if (event == MarchEvent::jump) step.from = lanes.low[lane], step.to = lanes.high[lane];
        if (flip) step.from = signPlace_[lane], step.to = start;
        if (flip || event == MarchEvent::jump || event == MarchEvent::crossing)
            step.sign = static_cast<int>(sign_[lane]);
        steps_.push_back(step);
    }
}

}  // namespace isoscope
