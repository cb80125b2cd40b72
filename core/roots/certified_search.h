// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/evaluate/affine_noise.h"
#include "core/roots/line_query.h"
#include "core/roots/root_settings.h"

namespace isoscope {

/// What is certain about the answer for one line.
enum class Verdict : std::uint8_t {
    certifiedHit,    ///< nothing between the start and the first root
    certifiedMiss,   ///< no root at all
    gap,             ///< the same, except for unresolved places narrower than a hundredth of the accuracy
    budgetExceeded,  ///< the evaluations ran out; the rest of the line was only sampled
    notCertified,    ///< the function holds an operation without proven bounds
};

const char* name(Verdict verdict);

/// The function along one line, negative inside: used where the enclosure cannot decide.
class LineFunction {
  public:
    virtual ~LineFunction() = default;
    virtual double value(double t) = 0;
};

/// A root with the interval it was narrowed down to; `refinable` roots have certain, opposite signs at the
/// ends.
struct BracketedRoot {
    Root root;
    double low = 0;
    double high = 0;
    bool refinable = false;
};

/// Marches along one line by enclosures of the function over pieces of it (design/evaluation.md), as a
/// machine that asks for one enclosure at a time:
///
///     search.begin(query, settings, sufficient, certain);
///     while (!search.done()) search.supply(enclosure on [start(), start() + length()], line);
///
/// Between the start and a root nothing is skipped but gaps of width resolution(): the larger of 0.01
/// accuracy (arc length) and what doubles can tell apart. A gap with opposite signs on both sides is searched
/// with point values: a continuous change of sign is a crossing, else a jump; a pole is no surface. Equal
/// signs on both sides (an even contact) give no root, and the verdict `gap`. A line that comes from outside
/// its container (near > 0) counts as outside the solid before: a surface that coincides with the wall is met
/// there.
///
/// Ends for every input: each step either moves on by at least resolution() or shortens the piece, and after
/// `budget` enclosures the rest of the line is sampled at `restSamples` points.
class CertifiedSearch {
  public:
    static constexpr std::uint32_t defaultBudget = 4000;
    static constexpr int restSamples =
        256;  ///< points at which the rest of a line is looked at when the budget is spent
    static constexpr int blurSamples =
        64;  ///< points for a stretch wider than the accuracy that rounding hides

    /// Ends after the first root with t >= `sufficient`, or max_trace roots. `certain` says whether the
    /// enclosures are.
    void begin(const LineQuery& query, const RootSettings& settings, double sufficient, bool certain,
               std::uint32_t budget = defaultBudget);

    bool done() const { return done_; }
    /// The piece to enclose next.
    double start() const { return t_; }
    double length() const { return h_; }
    /// Goes on with the enclosure of f on that piece.
    void supply(const AffineForm& form, LineFunction& line);

    /// In order of t; complete once done(). Without walls.
    const std::vector<BracketedRoot>& roots() const { return roots_; }
    Verdict verdict() const;
    double resolution() const { return resolution_; }
    std::uint32_t evaluations() const { return evaluations_; }

  private:
    void signKnown(double a, double b, double e, LineFunction& line);
    void signOpen(double a, double b, double e, bool known);
    void certainCrossing(double low, double high);
    void advance(double length);
    bool isNoise(double a, double b, double e) const;
    void stepOver(double e);
    void noteSign(int sign, double t, LineFunction& line);
    bool surfaceInWall(int sign, double t, LineFunction& line);
    void settleFlip(double low, double high, LineFunction& line);
    void sample(double end, int count, LineFunction& line);
    void sampleRest(LineFunction& line);
    void record(const BracketedRoot& root);
    void finishAtEnd(LineFunction& line);

    const RootSettings* settings_ = nullptr;
    double near_ = 0;
    double far_ = 0;
    double sufficient_ = 0;
    double tolerance_ = 0;  ///< the accuracy as a length in t
    double resolution_ = 0;
    double t_ = 0, h_ = 0;
    int sign_ = 0;          ///< last certain sign, 0 when there is none
    double signPlace_ = 0;  ///< up to here it is certain
    double noise_ = 0;      ///< error of the last piece of width resolution() that stayed open
    int rootsLeft_ = 1;
    std::uint32_t budget_ = defaultBudget;
    std::uint32_t evaluations_ = 0;
    bool entering_ = false;  ///< the line begins outside its container, and no sign is known yet
    bool certain_ = true;
    bool gap_ = false;
    bool blurred_ = false;  ///< stepped over more than the accuracy since the last certain sign
    bool exhausted_ = false;
    bool done_ = true;
    bool reachedEnd_ = false;
    std::vector<BracketedRoot> roots_;
};

}  // namespace isoscope
