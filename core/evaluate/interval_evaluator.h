// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/evaluate/tape/tape.h"
#include "core/evaluate/tape/uniform_values.h"
#include "core/numeric/interval.h"

namespace isoscope {

class PreparedFunction;

/// The value of one operation for all operands in given intervals. Undefined operands follow
/// evaluateOperation: they make a comparison 0 or 1, and so on. Constants, variables, parameters and loops
/// are not allowed.
Interval evaluateOperation(Operation operation, std::span<const Interval> operands,
                           const CrackleSettings* crackle = nullptr);

/// Encloses a tape's values over boxes of arguments. Sound: every value of the function (in real arithmetic,
/// with the constants and the parameter-only parts as rounded doubles) lies in the interval. One object per
/// thread.
class IntervalEvaluator {
  public:
    /// For a tape with these uniform values, which are needed by the constructor alone.
    IntervalEvaluator(std::shared_ptr<const Tape> tape, const UniformValues& uniforms);
    explicit IntervalEvaluator(const PreparedFunction& function);
    /// The uniform part is computed for this evaluator alone.
    IntervalEvaluator(std::shared_ptr<const Tape> tape, std::span<const double> parameters);

    /// The range of result `result` over a box of arguments; missing arguments are 0. A loop whose bounds are
    /// not known exactly gives Interval::unknown(), one with too many steps (LoopRange)
    /// Interval::undefined().
    Interval evaluate(std::span<const Interval> arguments, std::size_t result = 0);

    /// The range of operand `operand`, which there must be, of instruction `instruction` during the last
    /// evaluate().
    const Interval& operandRange(std::size_t instruction, int operand) const {
        return operandRanges_[firstOperands_[instruction] + static_cast<std::size_t>(operand)];
    }

    /// The evaluator of a loop's body; its ranges are hulls over all steps when the bounds are known.
    const IntervalEvaluator& loop(std::uint32_t index) const { return *loops_[index]; }

  private:
    void run(std::span<const Interval> arguments, double loopAllowance);
    Interval runLoop(const Instruction& instruction, double loopAllowance);
    void forgetRanges();

    std::shared_ptr<const Tape> tape_;
    std::vector<Interval> slots_;
    std::vector<Interval> operandRanges_;       ///< instruction by instruction
    std::vector<std::uint32_t> firstOperands_;  ///< of each instruction, in these
    std::vector<std::unique_ptr<IntervalEvaluator>> loops_;
};

}  // namespace isoscope
