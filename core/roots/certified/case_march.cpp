// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/certified/case_march.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/roots/certified/form_sign.h"

namespace isoscope {

namespace {

constexpr double unit = std::numeric_limits<double>::epsilon();
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// What doubles can hardly tell apart on a piece.
double grain(double start, double length) { return 32 * unit * (std::abs(start) + length); }

}  // namespace

bool CaseMarch::step(AffineEvaluator& forms, RayPieces& pieces, MarchLanes& lanes, const SignRule& rule,
                     std::size_t count, MarchEvent* events) {
    const AffineLanes whole = forms.evaluateCases(pieces, count, cases_);
    const double* const columns[] = {whole.center, whole.slope, whole.error};
    for (std::size_t k = 0; k < 3; ++k) std::copy_n(columns[k], batchLanes, forms_[k].begin());
    collect(pieces, lanes, rule.threshold, count);
    tryCases(forms, pieces, rule.threshold);
    for (const Undecided& at : undecided_) {
        // An error that a jump makes is no rounding, however long it lasts.
        lanes.unresolvedError[at.lane] = 0;
        if (!at.decided) continue;
        // One side of the threshold all along: any such form will do.
        forms_[0][at.lane] = rule.threshold + at.sign;
        forms_[1][at.lane] = forms_[2][at.lane] = 0;
    }
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

/// The undecided pieces, and their parts by the sides of the first jump that tells them.
void CaseMarch::collect(const RayPieces& pieces, const MarchLanes& lanes, double threshold,
                        std::size_t count) {
    undecided_.clear();
    dividedParts_.clear();
    for (std::size_t i = 0; i < count; ++i) {
        if (cases_.jump[i] == CaseLanes::noJump ||
            formSign(forms_[0][i], forms_[1][i], forms_[2][i], {threshold, false}) != 0)
            continue;
        const double t = pieces.start[i], half = pieces.length[i] / 2;
        const bool last = pieces.length[i] <= lanes.resolution[i];
        const std::size_t most = last ? mostPartsAtLast : pays() ? mostParts : 0;
        undecided_.push_back({i, t, pieces.length[i], t + (1 + cases_.firstLow[i]) * half,
                              t + (1 + cases_.firstHigh[i]) * half, most});
        divide({undecided_.size() - 1, t, pieces.length[i], 0, {}}, i);
    }
}

void CaseMarch::tryCases(AffineEvaluator& forms, const RayPieces& pieces, double threshold) {
    while (!dividedParts_.empty()) {
        std::swap(parts_, dividedParts_);
        dividedParts_.clear();
        std::erase_if(parts_, [&](const Part& part) { return !undecided_[part.owner].decided; });
        for (std::size_t k = 0; k < parts_.size(); k += batchLanes)
            runParts(forms, std::span(parts_).subspan(k, std::min(parts_.size() - k, batchLanes)), pieces,
                     threshold);
        tried_ += parts_.size();
    }
    for (const Undecided& at : undecided_) decided_ += at.decided;
}

void CaseMarch::runParts(AffineEvaluator& forms, std::span<const Part> parts, const RayPieces& pieces,
                         double threshold) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const Part& part = parts[i];
        for (std::size_t c = 0; c < 3; ++c) {
            partPieces_.origin[c][i] = pieces.origin[c][undecided_[part.owner].lane];
            partPieces_.direction[c][i] = pieces.direction[c][undecided_[part.owner].lane];
        }
        partPieces_.start[i] = part.start;
        partPieces_.length[i] = part.length;
        for (std::size_t k = 0; k < part.sideCount; ++k)
            cases_.sides[part.sides[k].first][i] = part.sides[k].second;
    }
    const AffineLanes sides = forms.evaluateCases(partPieces_, parts.size(), cases_);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const Part& part = parts[i];
        for (std::size_t k = 0; k < part.sideCount; ++k) cases_.sides[part.sides[k].first][i] = unknown;
        Undecided& at = undecided_[part.owner];
        const int sign = formSign(sides.center[i], sides.slope[i], sides.error[i], {threshold, false});
        if (sign == 0) {
            divide(part, i);
        } else {
            at.decided = at.decided && sign != -at.sign;
            at.sign = sign;
        }
    }
}

/// Leaves the part, which was enclosed in `lane`, to those of both sides of its first jump. Where that cannot
/// be, the piece remains undecided.
void CaseMarch::divide(const Part& part, std::size_t lane) {
    Undecided& at = undecided_[part.owner];
    const bool two = cases_.jump[lane] != CaseLanes::noJump && cases_.higher[lane] == cases_.higher[lane];
    at.decided = at.decided && two && part.sideCount < mostSides && at.partsLeft >= 2;
    if (!at.decided) return;
    at.partsLeft -= 2;
    const double half = part.length / 2, end = part.start + part.length;
    const double slack = 4 * unit * (std::abs(part.start) + part.length);
    const double low = std::max(part.start, part.start + (1 + cases_.low[lane]) * half - slack);
    const double high = std::min(end, part.start + (1 + cases_.high[lane]) * half + slack);
    const double rises = cases_.rises[lane];
    for (const bool higher : {false, true}) {
        Part side = part;
        side.sides[side.sideCount++] = {static_cast<std::uint32_t>(cases_.jump[lane]),
                                        higher ? cases_.higher[lane] : cases_.lower[lane]};
        if (rises != 0) {
            const bool isFirst = (rises > 0) != higher;
            side.start = isFirst ? part.start : low;
            side.length = (isFirst ? high : end) - side.start;
        }
        if (side.length > grain(side.start, side.length)) dividedParts_.push_back(side);
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
