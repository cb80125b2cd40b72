// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>

#include "core/evaluate/affine_evaluator.h"
#include "core/evaluate/tape/tape_workspace.h"

namespace isoscope {

class GlobalSimplification;
class PreparedFunction;

/// What SlopeEvaluator knows of pieces, side by side: arrays of batchLanes entries.
struct SlopeLanes {
    AffineLanes value;
    /// The derivative by t lies in slope +- spread all along the piece; where there is none (abs, min, max),
    /// those beside it do.
    const double* slope;
    const double* spread;
    /// What PointEvaluator and GradientEvaluator compute for the rounded point origin + t direction is no
    /// further from the truth than this.
    const double* rounding;
};

/// Encloses a function along pieces of bundles of rays as AffineEvaluator does, and how steep it is, and says
/// how exactly points are evaluated there. `spread` and `rounding` are infinite or not a number where nothing
/// is known; none of this counts where the value's form is not known. One object per thread.
class SlopeEvaluator {
  public:
    /// Whether slopes can be known at all: only sums, products, quotients, roots, exp, sin, cos, abs, min and
    /// max of a function that is not constant.
    static bool covers(const Tape& tape);

    explicit SlopeEvaluator(std::shared_ptr<const PreparedFunction> function);
    /// The function is prepared for this evaluator alone.
    SlopeEvaluator(std::shared_ptr<const Tape> tape, std::span<const double> parameters);

    /// For the first `count` lanes, valid until the next evaluation; t must not be negative.
    SlopeLanes evaluate(const RayPieces& pieces, const RaySpread& spread, std::size_t count);

    /// Evaluations of a piece so far: each call counts its lanes.
    std::uint64_t evaluations() const { return evaluations_; }

  private:
    std::shared_ptr<const PreparedFunction> function_;
    std::shared_ptr<const GlobalSimplification> global_;
    TapeWorkspace workspace_;
    std::uint64_t evaluations_ = 0;
};

}  // namespace isoscope
