// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/roots/certified/bundle_march.h"
#include "core/roots/certified/march_lanes.h"
#include "core/roots/line_query.h"
#include "core/roots/root_settings.h"
#include "core/roots/verdict.h"

namespace isoscope {

/// The function along one line, negative inside: used where the enclosure cannot decide.
class LineFunction {
  public:
    virtual ~LineFunction() = default;
    /// RootSettings::signedValue() of f at origin + t direction; NaN where f has no value.
    virtual double value(double t) = 0;
};

/// A root with the interval it was narrowed down to; `refinable` roots have certain, opposite signs at the
/// ends.
struct BracketedRoot {
    Root root;
    double low = 0;
    double high = 0;
    bool refinable = false;
    double steepness = 0;  ///< about the derivative at the root, 0 when nothing is known
    /// About what a step of Newton's with this derivative, from the middle, would leave to the root, in parts
    /// of the tolerance.
    double leftover = 1;
};

/// The place between low, where the function has the sign `sign`, and high, where it has the other, down to
/// neighbouring doubles: a crossing where it changes continuously, a pole where it changes through infinity,
/// else a jump. None where it changes through places without a value.
std::optional<BracketedRoot> locateSignChange(int sign, double low, double high, LineFunction& line);

/// The search along one line by enclosures of the function over pieces of it (docs/evaluation.md). march()
/// takes the plain steps of many lines together; this class begins them, and deals with what is not plain:
///
///     search.begin(query, settings, sufficient, certain, lane);
///     while (!search.done()) { enclose the pieces; march(...); search.handle(event, lane, line); }
///
/// Between the start and a root nothing is skipped but stretches of width resolution: the larger of 0.003
/// accuracy (arc length) and what doubles can tell apart. Between opposite signs such a stretch holds a root,
/// certified if it is no wider than the accuracy: a crossing where the function changes continuously, else a
/// jump; a pole is no surface. Equal signs on both sides (an even contact) give no root, and the verdict
/// `gap`. The threshold itself is outside. Within a 64th of the resolution of the places where the line
/// enters and leaves its container only the value at the wall itself counts. A line that comes from outside
/// (near > 0) counts as outside the solid before: a surface that coincides with the wall is met there.
///
/// Ends for every input: each step either moves on by at least the resolution or shortens the piece, and
/// after `budget` enclosures the rest of the line is sampled at `restSamples` points.
class GeneralSearch {
  public:
    static constexpr std::uint32_t defaultBudget = 4000;
    static constexpr int restSamples =
        256;  ///< points at which the rest of a line is looked at when the budget is spent
    static constexpr int blurSamples =
        64;  ///< points for a stretch wider than the accuracy that rounding hides

    /// The lane of MarchLanes, and of RayPieces, that a search works in.
    struct Lane {
        RayPieces& pieces;
        MarchLanes& lanes;
        std::size_t index;

        /// The piece of the lane that is enclosed next: t from start() on, length() wide.
        double& start() const { return pieces.start[index]; }
        double& length() const { return pieces.length[index]; }
        double& operator[](MarchLanes::Lanes MarchLanes::*array) const { return (lanes.*array)[index]; }
    };

    /// Ends after the first root with t >= `sufficient`, or max_trace roots; where that is a number, looks
    /// for none before. `certain` says whether the enclosures are. What is behind the budget is left alone
    /// unless `samples`.
    void begin(const LineQuery& query, const RootSettings& settings, double sufficient, bool certain,
               const Lane& lane, std::uint32_t budget = defaultBudget, bool samples = true);

    /// Right after begin(): passes over what is certain.
    void goTo(const CertainStart& start, const Lane& lane);

    /// From now on places where the sign changes through infinity are told among the roots; else they are no
    /// surface, and nothing.
    void listPoles() { listsPoles_ = true; }

    /// Goes no further than `end` for now: a lane that comes there waits. Limits only move on.
    void limitTo(double end, const Lane& lane);
    /// Passes over what holds no root, from where the sign is certain up to `end`. Returns whether the search
    /// is done by that.
    bool skipTo(double end, const Lane& lane);
    /// Whether the lane has come to the limit and the line goes on behind it; limitTo() lets it run again.
    bool waits(const Lane& lane) const {
        const double limit = lane[&MarchLanes::far];
        return !done_ && lane.start() >= limit && limit < far_;
    }

    /// Whether roots() and verdict() are final. A search that was never begun is done.
    bool done() const { return done_; }
    /// Deals with an event of the lane, other than none.
    void handle(MarchEvent event, const Lane& lane, LineFunction& line);

    /// The roots found, in order of t, without walls; complete once done().
    const std::vector<BracketedRoot>& roots() const { return roots_; }
    /// The worst that holds of the search; final once done(). Enclosures that are not certain give
    /// notCertified.
    Verdict verdict() const;

  private:
    static constexpr double notOpen = -1;

    void crossing(const Lane& lane);
    void jump(const Lane& lane, LineFunction& line);
    void newSign(int sign, const Lane& lane, LineFunction& line);
    bool passWall(const Lane& lane);
    void stepOver(const Lane& lane);
    void skipUndefined(const Lane& lane);
    void firstSign(int sign, double t, const Lane& lane, LineFunction& line);
    std::optional<BracketedRoot> signChange(int sign, double low, double high, LineFunction& line) const;
    void settleFlip(int sign, double low, double high, LineFunction& line);
    bool settleNarrowFlip(int sign, const Lane& lane, LineFunction& line);
    void closeStretch();
    double lengthBehind(const Lane& lane) const;
    void sample(double end, int count, const Lane& lane, LineFunction& line);
    void sampleRest(const Lane& lane, LineFunction& line);
    void finishAtEnd(const Lane& lane, LineFunction& line);
    void record(const BracketedRoot& root);

    double near_ = 0, far_ = 0;
    double sufficient_ = 0;
    double countsFrom_ = 0;  ///< roots before are none of those that may be found
    int rootsLeft_ = 1;
    bool entering_ = false;  ///< the line begins outside its container, and no sign is known yet
    bool closed_ = true;     ///< the container's wall is part of the surface
    bool certain_ = true;
    bool gap_ = false;
    double openFrom_ = notOpen;  ///< the last certain place before a stretch that may be a gap
    bool endTried_ = false;      ///< whether all but the wall where the line leaves was looked at alone
    bool unbounded_ = false;     ///< the function may be infinite on that stretch
    bool blurred_ = false;       ///< stepped over more than the accuracy since the last certain sign
    bool exhausted_ = false;
    bool done_ = true;
    bool listsPoles_ = false;
    bool samples_ = true;  ///< the rest of the line when the budget is spent
    std::vector<BracketedRoot> roots_;
};

}  // namespace isoscope
