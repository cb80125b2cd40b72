// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/view/explained_search.h"

#include <algorithm>
#include <cmath>

#include "core/roots/lipschitz/lipschitz_search.h"

namespace isoscope {

namespace {

/// Halves one interval by the rules of LipschitzLanes::examine, noting everything.
class Halving {
  public:
    Halving(const RootSettings& settings, GradientMemory& memory, const HalvingInterval& whole,
            const std::function<double(double)>& visit, ExplainedSearch& explained)
        : settings_(settings), memory_(memory), whole_(whole), visit_(visit), explained_(explained) {
        result_.lowest = whole.startValue;
    }

    HalvingResult run() {
        waiting_.push_back({whole_.start, whole_.startValue, whole_.end, whole_.endValue,
                            memory_.bound * whole_.speed * (whole_.end - whole_.start)});
        while (!waiting_.empty() && !result_.found && explained_.visited.size() < explainedPointLimit) {
            const Piece piece = waiting_.back();
            waiting_.pop_back();
            examine(piece);
        }
        if (!waiting_.empty() && !result_.found) explained_.complete = false;
        return result_;
    }

  private:
    struct Piece {
        double start, startValue, end, endValue;
        double reach;  ///< how far f could move over it
    };

    void examine(Piece piece) {
        const double width = piece.end - piece.start;
        noteSlope(piece, width);
        result_.lowest = std::min(result_.lowest, piece.endValue);
        const double middle = (piece.start + piece.end) / 2;
        const bool divisible = width >= settings_.accuracy && piece.start < middle && middle < piece.end;
        if (!divisible) {
            result_.found = piece.endValue < 0;
            result_.t = piece.end;
            return note(piece, result_.found ? IntervalFate::hit : IntervalFate::tooShort);
        }
        if (std::isnan(piece.startValue) || std::isnan(piece.endValue))
            return note(piece, IntervalFate::undefined);
        if (!(piece.startValue + piece.endValue - piece.reach < 0)) return note(piece, IntervalFate::pruned);
        const double here = whole_.sign * visit_(middle);
        waiting_.push_back({middle, here, piece.end, piece.endValue, piece.reach / 2});
        waiting_.push_back({piece.start, piece.startValue, middle, here, piece.reach / 2});
    }

    void noteSlope(Piece& piece, double width) {
        const double slope = std::abs(piece.endValue - piece.startValue) / (width * whole_.speed);
        if (!std::isfinite(slope)) return;
        memory_.steepest = std::max(memory_.steepest, slope);
        if (!settings_.evaluate) return;
        const double safety = (*settings_.evaluate)[1];
        if (!(slope * safety > memory_.bound) || !std::isfinite(slope * safety * safety)) return;
        memory_.bound = slope * safety * safety;
        piece.reach = memory_.bound * whole_.speed * width;
    }

    void note(const Piece& piece, IntervalFate fate) {
        explained_.intervals.push_back({piece.start, piece.end, fate});
    }

    const RootSettings& settings_;
    GradientMemory& memory_;
    const HalvingInterval whole_;
    const std::function<double(double)>& visit_;
    ExplainedSearch& explained_;
    HalvingResult result_;
    std::vector<Piece> waiting_;  ///< the next one last
};

}  // namespace

ExplainedSearch explainSearch(const LineQuery& line, const RootSettings& given,
                              const std::function<double(double)>& value) {
    ExplainedSearch explained;
    const RootSettings settings = given.usable();
    const std::function<double(double)> visit = [&](double t) {
        const double g = settings.signedValue(value(t));
        explained.visited.push_back({t, g});
        return g;
    };
    GradientMemory memory;
    memory.bound = settings.maxGradient;
    SearchTrail trail;
    LipschitzSearch search;
    search.begin(line, settings, std::numeric_limits<double>::infinity(), memory, explained.roots, trail);
    while (!search.done()) {
        if (!explained.complete) {
            search.giveUp();
        } else if (search.halving()) {
            search.halved(Halving(settings, memory, search.interval(), visit, explained).run());
        } else {
            const double t = search.wanted();
            const double f = value(t);
            explained.visited.push_back({t, settings.signedValue(f)});
            search.supply(f);
        }
    }
    return explained;
}

}  // namespace isoscope
