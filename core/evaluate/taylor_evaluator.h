// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <span>

#include "core/evaluate/gradient_evaluator.h"
#include "core/evaluate/steps/tape_programs.h"
#include "core/evaluate/tape/tape_simplifier.h"
#include "core/evaluate/tape/tape_workspace.h"

namespace isoscope {

class PreparedFunction;

/// Places on rays that stand in columns of the caller: lane i is origin + t direction, and what counts is the
/// ray from t - reach to t + reach. Whole vectors are read, up to batchLanes entries.
struct RayPlaces {
    std::array<const double*, 3> origin{};
    std::array<const double*, 3> direction{};
    const double* t = nullptr;
    const double* reach = nullptr;
};

/// What TaylorEvaluator knows, side by side: arrays of batchLanes entries. At t + s reach, -1 <= s <= 1, the
/// function lies within remainder s^2 + rounding of value + slope s.
struct TaylorLanes {
    GradientLanes point;  ///< value and gradient at t
    const double* slope;
    const double* remainder;
    const double* rounding;
};

/// Evaluates a function of x, y, z with its gradient at places on rays, and encloses it around them by its
/// tangent along the ray: what is left open grows with the square of the way from there, but for `rounding`,
/// roundings above all. Values and gradients are those of GradientEvaluator for the rounded points. Sound in
/// real arithmetic as AffineEvaluator is; nothing is known where `value`, `remainder` or `rounding` is not
/// finite. One object per thread.
class TaylorEvaluator {
  public:
    /// Whether anything can be known: only sums, products, quotients, roots, exp, sin, cos, abs, min, max and
    /// rounding, of a function that is not constant.
    static bool covers(const Tape& tape);

    explicit TaylorEvaluator(std::shared_ptr<const PreparedFunction> function);
    /// The function is prepared for this evaluator alone.
    TaylorEvaluator(std::shared_ptr<const Tape> tape, std::span<const double> parameters);

    /// For the first `count` lanes, valid until the next evaluation. With a shortened tape, whose choices
    /// must be right within the reach.
    TaylorLanes evaluate(const RayPlaces& places, std::size_t count,
                         const SimplifiedTape* simplifiedTape = nullptr);

    /// Evaluations of a place so far: each call counts its lanes.
    std::uint64_t evaluations() const { return evaluations_; }

  private:
    TapeWorkspace workspace_;
    TapePrograms programs_;
    std::uint64_t evaluations_ = 0;
};

}  // namespace isoscope
