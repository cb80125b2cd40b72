// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/function/function_graph.h"

namespace isoscope {

/// Number of a scratch slot of a tape.
using Slot = std::uint32_t;

/// One instruction: `target = operation(operands)`. Operands are slots; no instruction has a side exit. The
/// target may be the slot of an operand that is not needed afterwards, except for loops.
struct Instruction {
    Operation operation = Operation::constant;
    std::uint8_t operandCount = 0;
    Slot target = 0;
    std::array<Slot, 4> operands{};
    std::uint32_t index = 0;   ///< crackle settings or loop number of the tape
    std::uint32_t number = 0;  ///< its place in the whole tape, also where only a part of it is run
};

class Tape;
/// A loop of a tape: a body with its own slots, run once per value of the loop variable. `captured` are slots
/// of the outer tape, whose values are the body's arguments 1, 2, ...
struct TapeLoop {
    std::shared_ptr<const Tape> body;
    std::vector<Slot> captured;
};

/// A function as a straight list of instructions over few slots: dead code is gone, slots are reused as soon
/// as their value is no longer needed, constants and everything that depends on parameters alone are computed
/// once per change of a parameter by the `uniform` part. All number types run the same tape. Immutable.
class Tape {
  public:
    /// The tape of all results of `function`, which must be valid(). Takes time and memory linear in the
    /// nodes.
    static std::shared_ptr<const Tape> compile(const Function& function);

    /// Slots [0, argumentCount) hold the arguments. The uniform slots follow: they are the same for every
    /// point and keep their value between runs. Above them are the reused slots.
    int argumentCount() const { return argumentCount_; }
    std::uint32_t uniformCount() const { return uniformCount_; }
    std::uint32_t slotCount() const { return slotCount_; }
    bool isArgument(Slot slot) const { return slot < firstUniform(); }
    bool isUniform(Slot slot) const { return slot >= firstUniform() && slot < firstReused(); }
    Slot firstUniform() const { return static_cast<Slot>(argumentCount_); }
    Slot firstReused() const { return firstUniform() + uniformCount_; }

    /// Instructions that depend on the arguments.
    std::span<const Instruction> instructions() const { return instructions_; }
    /// Slot of each result (argument and uniform slots are possible).
    std::span<const Slot> results() const { return results_; }
    /// What Instruction::index of a crackle, or of a sum or product, stands for.
    const CrackleSettings& crackle(std::uint32_t index) const { return crackles_[index]; }
    const TapeLoop& loop(std::uint32_t index) const { return loops_[index]; }
    std::span<const TapeLoop> loops() const { return loops_; }

    /// Whether a product or a square is of what comes from operations with a range of their own (noise,
    /// angles, fractions): over long pieces little more is known of these than the range, so that the range
    /// of their product says more than what its form does. True for tapes with loops, of which it is not
    /// asked.
    bool multipliesRanges() const { return multipliesRanges_; }

    /// Values of the uniform slots, in slot order, for a parameter table (missing slots count as 0).
    std::vector<double> uniforms(std::span<const double> parameters) const;

  private:
    friend class TapeCompiler;

    int argumentCount_ = 3;
    std::uint32_t uniformCount_ = 0;
    std::uint32_t slotCount_ = 0;
    std::vector<Instruction> instructions_;
    std::vector<Slot> results_;
    std::vector<CrackleSettings> crackles_;
    std::vector<TapeLoop> loops_;
    bool multipliesRanges_ = false;
    /// The uniform part as a graph of its own (constants and parameters only), one result per uniform slot.
    Function uniformFunction_;
};

}  // namespace isoscope
