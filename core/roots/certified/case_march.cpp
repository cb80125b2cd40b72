// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/certified/case_march.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "core/roots/certified/form_sign.h"

namespace isoscope {

namespace {

constexpr double unit = std::numeric_limits<double>::epsilon();
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// What doubles can hardly tell apart on a piece.
double grain(double start, double length) { return 32 * unit * (std::abs(start) + length); }

/// How well the place of a jump has to be known. Forms are so good over so short a piece that it is.
double finest(double resolution) { return resolution / 64; }

}  // namespace

/// Whether what parts tell of the piece is more than its being cut shorter would.
bool CaseMarch::helps(const Undecided& at, double resolution) {
    if (at.sign == 0) return false;
    if (at.free >= at.start + at.length) return true;
    if (at.crosses && at.behind - at.free <= finest(resolution)) return true;
    const bool narrower = at.crosses && at.behind - at.start < at.length / 2;
    return at.length > resolution && (narrower || at.free - at.start > at.length / 8);
}

bool CaseMarch::step(AffineEvaluator& forms, RayPieces& pieces, MarchLanes& lanes, const SignRule& rule,
                     std::size_t count, MarchEvent* events) {
    const AffineLanes whole = forms.evaluateCases(pieces, count, cases_);
    const double* const columns[] = {whole.center, whole.slope, whole.error};
    for (std::size_t k = 0; k < 3; ++k) std::copy_n(columns[k], batchLanes, forms_[k].begin());
    collect(pieces, lanes, rule, count);
    tryCases(forms, pieces, lanes, rule);
    for (Undecided& at : undecided_) {
        // An error that a jump makes is no rounding, however long it lasts.
        lanes.unresolvedError[at.lane] = 0;
        if (!helps(at, lanes.resolution[at.lane])) {
            at.sign = 0;
            continue;
        }
        // One side of the threshold all along: any such form will do.
        const int side = rule.positivePolarity ? -at.sign : at.sign;
        forms_[0][at.lane] = rule.threshold + side * (1 + std::abs(rule.threshold));
        forms_[1][at.lane] = forms_[2][at.lane] = 0;
        pieces.length[at.lane] = at.free - at.start;
    }
    bool any =
        march(pieces, lanes, {forms_[0].data(), forms_[1].data(), forms_[2].data()}, rule, count, events);
    for (const Undecided& at : undecided_) {
        MarchEvent& event = events[at.lane];
        if (at.sign == 0) {
            if (event == MarchEvent::none) shorten(at, pieces, lanes);
            const bool placed = at.last - at.first <= finest(lanes.resolution[at.lane]);
            if (event == MarchEvent::unresolved && placed) lanes.jump[at.lane] = at.last;
        } else if (event == MarchEvent::none && at.free < at.start + at.length) {
            event = proceed(at, pieces, lanes);
            any = any || event != MarchEvent::none;
        }
    }
    return any;
}

std::array<std::uint8_t, batchLanes> CaseMarch::byCases() const {
    std::array<std::uint8_t, batchLanes> marks{};
    for (const Undecided& at : undecided_) marks[at.lane] = at.sign != 0;
    return marks;
}

/// The undecided pieces, and their parts by the sides of the first jump that tells them.
void CaseMarch::collect(const RayPieces& pieces, const MarchLanes& lanes, const SignRule& rule,
                        std::size_t count) {
    undecided_.clear();
    dividedParts_.clear();
    leaves_.clear();
    for (std::size_t i = 0; i < count; ++i) {
        if (cases_.jump[i] == CaseLanes::noJump ||
            formSign(forms_[0][i], forms_[1][i], forms_[2][i], rule) != 0)
            continue;
        const double t = pieces.start[i], length = pieces.length[i], half = length / 2;
        const bool last = length <= lanes.resolution[i];
        const std::size_t most = last ? mostPartsAtLast : pays() ? mostParts : 0;
        const int sign = lanes.signPlace[i] == t ? static_cast<int>(lanes.sign[i]) : 0;
        undecided_.push_back({i, t, length, t + (1 + cases_.firstLow[i]) * half,
                              t + (1 + cases_.firstHigh[i]) * half, most, sign, t + length});
        divide({undecided_.size() - 1, t, length, 0, {}}, i);
    }
}

void CaseMarch::tryCases(AffineEvaluator& forms, const RayPieces& pieces, const MarchLanes& lanes,
                         const SignRule& rule) {
    while (!dividedParts_.empty()) {
        std::swap(parts_, dividedParts_);
        dividedParts_.clear();
        std::erase_if(parts_, [&](const Part& part) {
            const Undecided& at = undecided_[part.owner];
            return at.vain || part.start > at.limit;
        });
        for (std::size_t k = 0; k < parts_.size(); k += batchLanes)
            runParts(forms, std::span(parts_).subspan(k, std::min(parts_.size() - k, batchLanes)), pieces,
                     lanes, rule);
        tried_ += parts_.size();
    }
    join();
    for (const Undecided& at : undecided_)
        decided_ += at.sign != 0 && (at.crosses || at.free - at.start > at.length / 2);
}

void CaseMarch::runParts(AffineEvaluator& forms, std::span<const Part> parts, const RayPieces& pieces,
                         const MarchLanes& lanes, const SignRule& rule) {
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
        const int sign = formSign(sides.center[i], sides.slope[i], sides.error[i], rule);
        if (sign == 0)
            divide(part, i);
        else
            addLeaf(part, sign, lanes.tolerance[undecided_[part.owner].lane]);
    }
}

/// Leaves the part, which was enclosed in `lane`, to those of both sides of its first jump, where that can
/// be.
void CaseMarch::divide(const Part& part, std::size_t lane) {
    Undecided& at = undecided_[part.owner];
    const bool two = cases_.jump[lane] != CaseLanes::noJump && cases_.higher[lane] == cases_.higher[lane];
    if (!two || part.sideCount >= mostSides || at.partsLeft < 2) return addLeaf(part, 0, 0);
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
        if (side.length > grain(side.start, side.length))
            dividedParts_.push_back(side);
        else
            addShort(side);
    }
}

void CaseMarch::addShort(const Part& part) {
    leaves_.push_back({part.owner, part.start, part.start + part.length, 0, true});
    undecided_[part.owner].differ = true;
}

/// Parts that begin beyond the first one with another sign by more than `reach` tell nothing any more.
void CaseMarch::addLeaf(const Part& part, int sign, double reach) {
    Undecided& at = undecided_[part.owner];
    leaves_.push_back({part.owner, part.start, part.start + part.length, sign});
    at.differ = at.differ || sign == 0 || sign == -at.partSign || sign == -at.sign;
    at.vain = at.vain || (sign == 0 && part.start == at.start);
    at.partSign = sign;
    if (sign == 0 || sign == -at.sign) at.limit = std::min(at.limit, part.start + reach);
}

void CaseMarch::join() {
    for (Undecided& at : undecided_) {
        at.sign = at.vain ? 0 : at.sign == 0 && !at.differ ? at.partSign : at.sign;
        at.free = at.start + at.length;
    }
    std::erase_if(leaves_, [&](const Leaf& leaf) {
        const Undecided& at = undecided_[leaf.owner];
        return at.vain || !at.differ;
    });
    std::sort(leaves_.begin(), leaves_.end(), [](const Leaf& a, const Leaf& b) {
        return a.owner != b.owner ? a.owner < b.owner : a.start < b.start;
    });
    for (std::size_t begin = 0, end = 0; begin < leaves_.size(); begin = end) {
        while (end < leaves_.size() && leaves_[end].owner == leaves_[begin].owner) ++end;
        join(undecided_[leaves_[begin].owner], std::span(leaves_).subspan(begin, end - begin));
    }
}

/// Reads off the parts of a piece, in order of where they begin, how far it is free. They overlap: a place
/// has a sign where all parts that hold it have. Where a short part is, it is not known.
void CaseMarch::join(Undecided& at, std::span<const Leaf> leaves) {
    const bool known = at.sign != 0;
    const auto first =
        std::find_if(leaves.begin(), leaves.end(), [](const Leaf& leaf) { return !leaf.isShort; });
    if (first == leaves.end()) {
        at.sign = 0;
        return;
    }
    if (!known) at.sign = first->sign;
    const auto other = std::find_if(first, leaves.end(),
                                    [&](const Leaf& leaf) { return !leaf.isShort && leaf.sign != at.sign; });
    if (other != leaves.end()) at.free = std::max(other->start, at.start);
    std::for_each(std::make_reverse_iterator(other), leaves.rend(), [&](const Leaf& leaf) {
        if (leaf.isShort && leaf.end >= at.free) at.free = std::min(at.free, leaf.start);
    });
    double unsure = at.start;  // up to here a part that is left out may have another sign
    for (const Leaf& leaf : leaves)
        if (leaf.isShort && leaf.start <= unsure) unsure = std::max(unsure, leaf.end);
    if (!known && at.free <= unsure) at.sign = 0;
    if (other == leaves.end() || at.sign == 0) return;
    at.behind = at.free;
    for (auto leaf = leaves.begin(); leaf != other; ++leaf) at.behind = std::max(at.behind, leaf->end);
    double opposite = at.start;
    at.crosses = true;
    for (auto leaf = other; leaf != leaves.end() && leaf->start <= at.behind; ++leaf) {
        at.crosses = at.crosses && (leaf->isShort || leaf->sign != 0);
        double& end = leaf->sign == -at.sign ? opposite : at.behind;
        end = std::max(end, leaf->end);
    }
    at.crosses = at.crosses && opposite > at.behind;
}

/// The lane is where the free part of its piece ends: at the jump, or at what is to be looked at again.
MarchEvent CaseMarch::proceed(const Undecided& at, RayPieces& pieces, MarchLanes& lanes) {
    const double t = pieces.start[at.lane], end = at.start + at.length;
    const double least = finest(lanes.resolution[at.lane]);
    if (at.crosses && at.behind - at.free <= least) {
        lanes.low[at.lane] = at.free;
        lanes.high[at.lane] = at.behind;
        lanes.resumed[at.lane] = end - at.behind;
        return MarchEvent::jump;
    }
    const double wanted = at.crosses             ? at.behind - t + least
                          : at.first > t + least ? at.first - t - least / 2
                                                 : end - t;
    const double rest = lanes.far[at.lane] - t;
    pieces.length[at.lane] = std::min(std::max(wanted, lanes.resolution[at.lane]), rest);
    lanes.resumed[at.lane] = end - t - pieces.length[at.lane];
    return MarchEvent::none;
}

/// Ends the piece right before the first jump; at the jump itself, right behind it.
void CaseMarch::shorten(const Undecided& at, RayPieces& pieces, MarchLanes& lanes) {
    const double t = pieces.start[at.lane];
    const double least = finest(lanes.resolution[at.lane]);
    const double rest = at.start + at.length - t;
    double& length = pieces.length[at.lane];
    const bool before = at.first - t > 2 * least;
    const double wanted = before ? at.first - t - least : std::max(at.last - t, least) + least;
    // A jump that may be anywhere tells nothing.
    if (!(wanted <= (before ? 0.9 : 0.5) * rest) || (before && wanted < length)) return;
    length = std::min(wanted, lanes.far[at.lane] - t);
    lanes.resumed[at.lane] = rest - wanted;
}

}  // namespace isoscope
