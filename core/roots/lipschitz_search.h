// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

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

/// POV-Ray's search along one line (spec/povray-solver.md) as a machine that asks for one function value at a
/// time, so that many lines can share a vectorised evaluation:
///
///     search.begin(query, settings, sufficient, memory);
///     while (!search.done()) search.supply(value of f at search.wanted());
///
/// Where the page is silent, the rules were measured on the program:
/// - An interval with a NaN at either end holds no root, and a NaN is not inside. So no NaN ever becomes a t.
/// - A container chord below `accuracy` shows nothing, walls included; so does one that is shortened below it
///   because the start was moved to 5 accuracy.
/// - The wall at the exit does not count against max_trace.
///
/// Beyond POV-Ray, to end for every input: an interval that cannot be halved any more counts as short as
/// `accuracy`; infinite slopes are not remembered; after `evaluationLimit` values the search gives up and
/// keeps what it has.
class LipschitzSearch {
  public:
    static constexpr std::uint64_t evaluationLimit = 5'000'000;

    /// Ends after the first root with t >= `sufficient`. `settings` must be usable(); `settings` and `memory`
    /// must live as long as the search.
    void begin(const LineQuery& query, const RootSettings& settings, double sufficient,
               GradientMemory& memory);

    bool done() const { return phase_ == Phase::done; }
    /// Parameter at which the next value is needed.
    double wanted() const { return wanted_; }
    /// Goes on with f at wanted().
    void supply(double value);

    /// In order of t; complete once done().
    const RootList& roots() const { return roots_; }
    bool exhausted() const { return exhausted_; }
    /// For POV-Ray's memory of misses.
    const SearchTrail& trail() const { return trail_; }

  private:
    enum class Phase { nearEnd, movedStart, exitWall, farEnd, nextStart, middle, done };
    /// The right half of an interval, waiting: its left end is where the search stands when it is its turn.
    struct Pending {
        double end;
        double endValue;
        double reach;
    };

    void ask(Phase phase, double t);
    void atNearEnd();
    void moveStart();
    void startSearch();
    void farEndKnown();
    void subdivide();
    bool nextInterval();
    void noteSlope(double slope, double width);
    void noteNextSlopeAbove();
    void found(double t);
    /// Counts a root that was just noted; true when the line is done with.
    bool enough(double t);
    void finish();

    const RootSettings* settings_ = nullptr;
    GradientMemory* memory_ = nullptr;
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

    // The interval in work; values are h = sign g. `reach` is L: how far f could move over it.
    double start_ = 0, startValue_ = 0;
    double end_ = 0, endValue_ = 0;
    double reach_ = 0;
    double noteworthy_ = 0;  ///< slopes up to here change nothing
    std::vector<Pending> pending_;

    RootList roots_;
    SearchTrail trail_;
    std::uint64_t evaluations_ = 0;
    bool exhausted_ = false;
};

}  // namespace isoscope
