// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "core/roots/line_query.h"
#include "core/roots/root_settings.h"

namespace isoscope {

/// The bound on the gradient in force (max_gradient, unless `evaluate` moves it) and the steepest slope seen.
struct GradientMemory {
    double bound = 1.1;
    double steepest = 0;
};

/// The searches of one line, one after the other: each ends with a crossing, the last one perhaps without.
struct SearchTrail {
    std::array<double, 10> starts{};  ///< t where each search began
    int count = 0;
    bool missed = false;  ///< the last search found nothing
    double lowest = 0;    ///< smallest h at the ends of the intervals of the last search
};

/// An interval to be searched for the first step from h >= 0 to h < 0; values are h = sign g.
struct HalvingInterval {
    double start = 0, startValue = 0;
    double end = 0, endValue = 0;
    double sign = 1;
    double speed = 1;  ///< length of the line's direction
};

/// What halving a HalvingInterval came to: a crossing, or the smallest value met.
struct HalvingResult {
    bool found = false;
    double t = 0;       ///< of the crossing, when one was found
    double lowest = 0;  ///< smallest h at the ends of the intervals, when none was found
};

/// POV-Ray's rules about the ends of a line and about the crossings on it (docs/povray/solver.md), as a
/// machine that asks for what it needs, so that many lines can share vectorised evaluations. LipschitzLanes
/// searches the intervals in between.
///
///     search.begin(query, settings, sufficient, memory, roots, trail);
///     while (!search.done())
///         if (search.halving()) search.halved(what was found in search.interval());
///         else search.supply(value of f at search.wanted());
///
/// Where the page is silent, the rules were measured on the program:
/// - An interval with a NaN at either end holds no root, and a NaN is not inside. So no NaN ever becomes a t.
/// - A container chord below `accuracy` shows nothing, walls included; so does one that is shortened below it
///   because the start was moved to 5 accuracy.
/// - The wall at the exit does not count against max_trace.
///
/// Beyond POV-Ray, to end for every input: an interval that cannot be halved any more counts as short as
/// `accuracy`; infinite slopes are not remembered; a search that has taken more than `evaluationLimit` values
/// is told to give up and keeps what it has.
class LipschitzSearch {
  public:
    static constexpr std::uint64_t evaluationLimit = 5'000'000;

    /// Ends after the first root with t >= `sufficient`. `settings` must be usable(); all that is handed over
    /// by reference must live as long as the search. The roots go to `roots`, in order of t, complete once
    /// done(); the trail, for POV-Ray's memory of misses, to `trail`.
    void begin(const LineQuery& query, const RootSettings& settings, double sufficient,
               GradientMemory& memory, RootList& roots, SearchTrail& trail);

    /// Whether the roots handed to begin() are complete. A search that was never begun is done.
    bool done() const { return phase_ == Phase::done; }
    /// Whether interval() is to be searched, rather than a value supplied.
    bool halving() const { return phase_ == Phase::halving; }
    /// Parameter at which the next value is needed.
    double wanted() const { return wanted_; }
    /// Goes on with f at wanted().
    void supply(double value);
    /// What is to be searched while halving(); has no meaning otherwise.
    const HalvingInterval& interval() const { return interval_; }
    /// Goes on with what was found in interval().
    void halved(const HalvingResult& result);
    /// Ends the search with the roots found so far.
    void giveUp() { finish(); }

  private:
    enum class Phase { nearEnd, movedStart, exitWall, farEnd, nextStart, halving, done };

    void ask(Phase phase, double t);
    void atNearEnd();
    void moveStart();
    void startSearch();
    /// Counts a root that was just noted; true when the line is done with.
    bool enough(double t);
    void finish();

    const RootSettings* settings_ = nullptr;
    GradientMemory* memory_ = nullptr;
    RootList* roots_ = nullptr;
    SearchTrail* trail_ = nullptr;
    int rootsLeft_ = 0;
    double sufficient_ = 0;
    double speed_ = 1;

    Phase phase_ = Phase::done;
    double wanted_ = 0;
    double near_ = 0, nearValue_ = 0;  ///< values are g, before the sign
    double far_ = 0, farValue_ = 0;
    bool farKnown_ = false;
    bool exitWall_ = false;
    double sign_ = 1;
    HalvingInterval interval_;
};

}  // namespace isoscope
