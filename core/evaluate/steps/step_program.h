// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/evaluate/tape/tape_workspace.h"

namespace isoscope {

/// What a step does to the accumulator. "From" and "into" have the accumulator as the second operand.
enum class StepOperation : std::uint8_t {
    load,
    add,
    subtract,
    subtractFrom,
    multiply,
    multiplyInto,  ///< the same for plain numbers, but not for others
    divide,
    divideInto,
    minimum,
    minimumFrom,
    maximum,
    maximumFrom,
    // Those without an operand.
    square,
    negate,
    absolute,
    squareRoot,
    store,
    save0,  ///< a copy of the accumulator that StepOperand::saved0 reads
    save1,
    end,  ///< behind the last step of a stretch
};

/// Where the operand of a step comes from: a and b are slots, u is a uniform slot. Squares and products of
/// values in memory are computed where they are read.
enum class StepOperand : std::uint8_t {
    lanes,         ///< a
    square,        ///< a a
    product,       ///< a b
    scaled,        ///< a u
    scaledSquare,  ///< (a a) u
    uniform,       ///< u
    saved0,
    saved1,
};

/// One step of a StepProgram.
struct ProgramStep {
    static constexpr Slot unused = 0xffffffff;
    static constexpr int operandCount = 8;
    static constexpr int operandlessFrom = static_cast<int>(StepOperation::square);

    /// Steps are told apart by one number, for a table of what to do.
    static constexpr std::uint8_t codeOf(StepOperation operation, StepOperand operand = StepOperand::lanes) {
        const int row = static_cast<int>(operation);
        return static_cast<std::uint8_t>(row < operandlessFrom
                                             ? row * operandCount + static_cast<int>(operand)
                                             : operandlessFrom * (operandCount - 1) + row);
    }

    std::uint8_t code;
    Slot a = unused;                 ///< also what `store` writes, and u where there is no other slot
    Slot b = unused;                 ///< or u
    const double* lanesA = nullptr;  ///< memory of the slots; one number for a uniform slot
    const double* lanesB = nullptr;
    double* target = nullptr;  ///< of `store`
};

/// A tape, bound to a workspace: its sums, products and the like as steps of a machine with one accumulator
/// and, for plain numbers (a workspace of one component), two copies of it, so that most values never travel
/// through memory, which costs more than computing them. For other numbers there are only the steps up to
/// `multiplyInto`, and `square`, `negate` and `store`. The results are, bit by bit, those of the instructions
/// one after the other.
class StepProgram {
  public:
    /// Steps, and the instructions of the tape to run after them (none after the last).
    struct Stretch {
        std::uint32_t firstStep;
        std::uint32_t stepCount;  ///< where it is not 0, a step `end` follows
        std::span<const Instruction> instructions;
    };

    /// Takes time and memory linear in the instructions. Reads and writes the memory of this workspace, which
    /// must outlive the program (it may be moved).
    explicit StepProgram(TapeWorkspace& workspace);
    /// The same for other instructions on the workspace's slots, which must outlive the program, too.
    StepProgram(TapeWorkspace& workspace, std::span<const Instruction> instructions,
                std::span<const Slot> results);

    /// Reads the arguments from where the workspace has them now, and writes into the workspace.
    void bind(TapeWorkspace& workspace);

    /// Writes the value of a slot to the memory of the caller, not to the workspace, until bind(). False,
    /// without effect, when it is not the last thing the program writes.
    bool writeTo(Slot slot, double* lanes);

    /// What it was made from.
    std::span<const Instruction> instructions() const { return instructions_; }

    /// The stretches in the order they run, and the steps of one of them, without its `end`. Valid while the
    /// program lives.
    std::span<const Stretch> stretches() const { return stretches_; }
    std::span<const ProgramStep> steps(const Stretch& stretch) const {
        return std::span(steps_).subspan(stretch.firstStep, stretch.stepCount);
    }

  private:
    static void bind(ProgramStep& step, TapeWorkspace& workspace);

    std::span<const Instruction> instructions_;
    std::vector<ProgramStep> steps_;
    std::vector<Stretch> stretches_;
    std::vector<std::uint32_t> movable_;     ///< steps that read an argument
    std::vector<const double*> arguments_;   ///< where they read them
    std::size_t last_ = 0;                   ///< the step that writes last, if there is one
    Slot lastStored_ = ProgramStep::unused;  ///< what it writes
    double* ownTarget_ = nullptr;            ///< and where, unless the caller wants it elsewhere
};

}  // namespace isoscope
