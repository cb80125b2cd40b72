// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "core/roots/line_query.h"
#include "core/roots/lipschitz/lipschitz_kernel.h"
#include "core/roots/lipschitz/lipschitz_search.h"
#include "core/roots/root_settings.h"

namespace isoscope {

/// Calls visit(lane) for the lanes of a mask, highest first.
template <class Visit>
void forEachLane(std::uint64_t mask, Visit visit) {
    while (mask != 0) {
        const int lane = 63 - std::countl_zero(mask);
        mask &= ~(std::uint64_t{1} << lane);
        visit(static_cast<std::size_t>(lane));
    }
}

/// Up to 64 lines side by side. Each lane wants f at one place of its line at a time: for the rules about the
/// ends of a line (LipschitzSearch, which says so by ask()) or because it is halving an interval. The halving
/// is done here, for all lanes at once, in the order in which POV-Ray's recursion would do it:
///
///     find(t1, h1, t2, h2, L) of docs/povray/solver.md
///
/// A right half without a root and without a slope to be noted is forgotten when it is made, not when its
/// turn comes: that is all that differs, and no result depends on it.
class LipschitzLanes {
  public:
    static constexpr std::size_t limit = HalvingState::laneLimit;

    /// `settings` must be usable(); the bound in force begins with its maxGradient.
    explicit LipschitzLanes(const RootSettings& settings);

    /// Bound and steepest slope, shared by all lanes: halving raises the slope and, with `evaluate`, the
    /// bound.
    GradientMemory& memory() { return memory_; }
    const GradientMemory& memory() const { return memory_; }

    /// The line that the lane works on from now on.
    void place(std::size_t lane, const LineQuery& query);
    /// The lane wants f at `t`.
    void ask(std::size_t lane, double t) { state_.wanted[lane] = t; }
    /// Begins to halve; false when that is over without any value, see result().
    bool start(std::size_t lane, const HalvingInterval& interval);
    /// Lanes that are halving.
    std::uint64_t halving() const { return halving_; }
    /// Takes a lane out of the halving.
    void drop(std::uint64_t lanes) { halving_ &= ~lanes; }
    /// Lane `to` goes on with what lane `from` was doing, which is then out of use.
    void move(std::size_t from, std::size_t to);

    /// The points at which lanes [0, count) want f.
    std::span<const double> points(int axis, std::size_t count) const {
        return std::span(state_.point[static_cast<std::size_t>(axis)]).first(count);
    }
    /// Computes what points() gives, from what the first `count` lanes have asked for.
    void computePoints(std::size_t count) { placePoints(state_, count); }

    /// Carries all halving lanes among [0, count) one step on, given f at the points. Returns those that came
    /// to an end by it; they are no longer halving.
    std::uint64_t advance(std::span<const double> values);
    /// How the last halving of a lane has ended.
    HalvingResult result(std::size_t lane) const;

  private:
    /// A right half, waiting for its turn.
    struct Pending {
        double start, startValue;
        double end, endValue;
        /// L, which is not negative. With its sign bit set the interval still has to be examined; without, it
        /// is known to be in need of halving and to have no noteworthy slope.
        double reach;
    };

    void putAside(std::size_t lane, const Pending& pending);
    bool stepExactly(std::size_t lane, double value);
    bool examine(std::size_t lane);
    bool next(std::size_t lane);
    bool takePending(std::size_t lane);
    void noteSlope(std::size_t lane, double slope, double width);
    void noteNextSlopeAbove();

    RootSettings settings_;
    GradientMemory memory_;
    HalvingLimits limits_;
    HalvingState state_;
    std::uint64_t halving_ = 0;
    std::uint64_t found_ = 0;  ///< lanes whose last halving has ended with a root, at the end of the interval
    /// What waits in the lanes: the entries of one depth side by side, so that the few depths in use stay in
    /// the cache.
    std::vector<Pending> pending_;
    std::array<std::size_t, limit> pendingCount_{};
};

}  // namespace isoscope
