// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/function/function_graph.h"
#include "core/roots/line_query.h"
#include "tests/support/exact_range.h"

namespace isoscope::test {

/// f - threshold along a line, enclosed at 200 bits: what a program says of the line is followed by other
/// means than its own. Nodes that depend on parameters alone count as their rounded values, as in the
/// program.
class ExactLine {
  public:
    /// The result 0 of a function of x, y, z.
    ExactLine(Function function, std::span<const double> parameters, const LineQuery& line, double threshold);

    /// Whether every node has a rule (hasExactRule); else nothing may be asked.
    bool isCovered() const { return isCovered_; }

    enum class Answer {
        yes,
        no,    ///< at some point, for certain
        open,  ///< the pieces ran out, or doubles cannot hold what is computed on the way
    };
    /// Whether f - threshold has the sign (1 or -1) all over [from, to]: by halves, at most `most` of them.
    Answer hasSign(int sign, double from, double to, int most = 4000);
    /// Where the last `no` was found.
    double refutedAt() const { return refutedAt_; }
    /// f at t, with its derivative by t; valid until something else is asked.
    const ExactJet& at(double t);
    /// The same at start + share * length, exactly there.
    const ExactJet& at(double start, double length, double share);
    /// Whether all that was computed for that, values and derivatives, is 0 or between 1 / limit and limit.
    bool isWithin(double limit) const;
    /// Whether f may have no value at the share of a piece.
    bool maybeUndefinedAt(double start, double length, double share);
    /// The sign of f - threshold at t: 0 where it is 0, not certain or has no value.
    int signAt(double t);
    /// Whether |f - (center + slope s)| <= error at the share (0 to 1) of a piece, s = 2 share - 1; true
    /// where f is not known well enough to tell.
    bool admits(double start, double length, double share, double center, double slope, double error);

    /// Ranges enclosed so far.
    std::uint64_t evaluations() const { return evaluations_; }

  private:
    struct Piece {
        ExactNumber from, to;
    };
    const ExactJet& evaluate(const ExactRange& t);
    ExactRange valueOver(const Piece& piece);
    ExactNumber placeIn(double start, double length, double share) const;

    Function function_;
    LineQuery line_;
    ExactRange threshold_;
    std::vector<NodeId> order_;     ///< nodes that depend on the point
    std::vector<ExactJet> values_;  ///< of all nodes up to the result
    bool isCovered_ = true;
    std::uint64_t evaluations_ = 0;
    double refutedAt_ = 0;
};

}  // namespace isoscope::test
