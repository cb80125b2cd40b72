// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/evaluate/tape/tape_simplifier.h"
#include "core/evaluate/tape/tape_workspace.h"
#include "core/numeric/interval.h"

namespace isoscope {

class PreparedFunction;

/// Boxes of x, y, z side by side.
struct BoxLanes {
    std::array<std::array<double, batchLanes>, 3> low{};
    std::array<std::array<double, batchLanes>, 3> high{};
};

/// Encloses a tape's values over up to batchLanes boxes at once, with vector instructions that round upwards
/// (the lower ends are kept negated). Sound like IntervalEvaluator, and as tight but for the last digits and
/// for sine and cosine of arguments beyond 25000. Arguments behind the third are 0; an end that is NaN counts
/// as infinite. Needs the rounding mode to nearest around it. A lane's answer does not depend on the others.
/// One object per thread.
class BoxEvaluator {
  public:
    explicit BoxEvaluator(std::shared_ptr<const PreparedFunction> function);
    /// The function is prepared for this evaluator alone.
    BoxEvaluator(std::shared_ptr<const Tape> tape, std::span<const double> parameters);

    /// out[i] encloses result `result` over box i, for the first out.size() boxes (at most batchLanes).
    void evaluate(const BoxLanes& boxes, std::span<Interval> out, std::size_t result = 0);

    /// The same for a tape that TapeSimplifier made from this one. The choices are left as they are.
    void evaluate(const BoxLanes& boxes, const SimplifiedTape& tape, std::span<Interval> out);

    /// As the second, and notes which choices are decided in each box: choices[k] for the k-th choosing
    /// instruction of the tape. What cannot change the sign that `signs` is about counts as not chosen.
    void evaluateChoices(const BoxLanes& boxes, const SimplifiedTape& tape, const SignStakes& signs,
                         std::span<Interval> out, std::vector<LaneChoices>& choices);

    /// What the last evaluate() of the whole tape decided in all its boxes alike: one entry for each choosing
    /// instruction (isChoice) in order, as TapeSimplifier wants them.
    std::span<const Choice> choices() const { return choices_; }

    /// Boxes evaluated so far.
    std::uint64_t evaluations() const { return evaluations_; }

  private:
    void placeArguments(const BoxLanes& boxes, std::size_t count);
    void run(const BoxLanes& boxes, std::span<const Instruction> instructions, Slot result,
             std::span<Interval> out);
    LaneChoices decide(const Instruction& instruction, std::size_t count, const SignLevel* level) const;
    void read(Slot result, std::span<Interval> out) const;

    std::shared_ptr<const PreparedFunction> function_;
    const Tape* tape_;
    TapeWorkspace workspace_;
    std::vector<Choice> choices_;
    std::uint64_t evaluations_ = 0;
};

}  // namespace isoscope
