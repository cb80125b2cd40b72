// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/evaluate/algebra/interval_gradient.h"
#include "core/evaluate/tape/tape.h"

namespace isoscope {

class IntervalGradientEvaluator;

/// The operands of a tape that are functions of one other operand alone, such as 1/(1 + exp(-6 u)) with
/// u = x + y z. Interval arithmetic on each of their operations forgets that all of these have the same u;
/// by the slopes of the whole, over parts of the range of u, it is known. The rest is the chain rule. One
/// object per thread.
class UnivariateParts {
  public:
    /// Of a tape with these values of its uniform slots. None for tapes with loops or of very many
    /// instructions.
    UnivariateParts(const Tape& tape, std::span<const double> uniforms);
    ~UnivariateParts();

    /// Whether there are none, so that they say nothing that operations do not.
    bool empty() const { return parts_.empty(); }
    /// About how many evaluations of the tape all of them cost together, by their instructions.
    std::uint64_t work() const { return work_; }
    /// Begins a run of the tape over a box with these coordinates, up to three.
    void begin(std::span<const IntervalGradient* const> coordinates);
    /// To be called behind each instruction, in their order. Narrows `result` where it ends a part; never
    /// widens it, and leaves what has a hazard or open choices as it is.
    void note(std::size_t instruction, IntervalGradient& result);

  private:
    struct Part {
        std::size_t base;    ///< a coordinate (0 to 2), or 3 + an instruction
        std::size_t result;  ///< an instruction
        std::unique_ptr<IntervalGradientEvaluator> function;  ///< of one argument
        IntervalGradient from;                                ///< the base over the box
    };

    static void refine(Part& part, IntervalGradient& result);

    std::vector<Part> parts_;
    std::uint64_t work_ = 0;
};

}  // namespace isoscope
