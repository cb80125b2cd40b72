// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/evaluate/algebra/interval_gradient.h"
#include "core/evaluate/tape/tape.h"
#include "core/evaluate/tape/uniform_values.h"

namespace isoscope {

class PreparedFunction;

/// Encloses a tape's values, gradients and second derivatives in its first three arguments over a box:
/// forward differentiation with outward rounding. What is proven is stated at IntervalGradient, for the
/// function in real arithmetic with constants and parameter-only parts as rounded doubles; noise by the
/// bounds of core/numeric/noise_bounds.h. A box of no extent gives the gradient at a point, with its rounding
/// errors.
///
/// Where no bound exists the answer says so by its hazard; nothing is ever NaN. Loops whose number of steps
/// changes within the box, and loops of more than `stepLimit` steps, are `unknown`. One object per thread.
class IntervalGradientEvaluator {
  public:
    static constexpr double stepLimit = 10'000;

    /// For a tape with these uniform values, which are needed by the constructor alone.
    IntervalGradientEvaluator(std::shared_ptr<const Tape> tape, const UniformValues& uniforms);
    explicit IntervalGradientEvaluator(const PreparedFunction& function);
    /// The uniform part is computed for this evaluator alone.
    IntervalGradientEvaluator(std::shared_ptr<const Tape> tape, std::span<const double> parameters);

    /// Result `result` over the box of the first three arguments. Further arguments are 0. The reference is
    /// valid until the next call.
    const IntervalGradient& evaluate(std::span<const Interval, 3> box, std::size_t result = 0);

    /// Result 0 at a point of the box of the last evaluate(), with the choices left open that were open in
    /// that box: what all pieces are at the point.
    const IntervalGradient& evaluatePieces(std::span<const Interval, 3> point);

    /// Boxes evaluated so far.
    std::uint64_t evaluations() const { return evaluations_; }

  private:
    void run(double loopAllowance);
    IntervalGradient execute(const Instruction& instruction, std::size_t index, double loopAllowance);
    IntervalGradient runLoop(const Instruction& instruction, double loopAllowance);

    std::shared_ptr<const Tape> tape_;
    std::vector<IntervalGradient> slots_;
    std::vector<std::unique_ptr<IntervalGradientEvaluator>> loops_;
    std::vector<bool> open_;  ///< by instruction: the choices that the last box left open
    bool keepsOpen_ = false;  ///< whether these stay as they are
    std::uint64_t evaluations_ = 0;
};

/// The operation for operands given over a box; loops, constants, variables and parameters are not allowed.
IntervalGradient evaluateOperation(Operation operation, std::span<const IntervalGradient* const> operands,
                                   const CrackleSettings* crackle = nullptr);

}  // namespace isoscope
