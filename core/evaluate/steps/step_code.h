// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "core/evaluate/tape/tape.h"

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

/// What numbers a step works on: those of one component; of more; or forms by cases, whose whole numbers are
/// no matter of steps (findWholeNumbers).
enum class StepNumberKind : std::uint8_t { plain, composed, byCases };

/// Instructions of a tape: their sums, products and the like as steps of a machine with one accumulator and,
/// for plain numbers, two copies of it, so that most values never travel through memory, which costs more
/// than computing them. For other numbers there are only the steps up to `multiplyInto`, and `square`,
/// `negate` and `store`. Operands are slots still: a StepProgram binds them to memory. Immutable, so that the
/// programs of all threads and number types share it.
class StepCode {
  public:
    /// Steps, and the instructions of the tape to run after them (none after the last).
    struct Stretch {
        std::uint32_t firstStep;
        std::uint32_t stepCount;  ///< where it is not 0, a step `end` follows
        std::span<const Instruction> instructions;
    };

    /// Takes time and memory linear in the instructions, which are the tape's or a SimplifiedTape's and must
    /// outlive the code, as must the tape. `results` are the slots whose values are asked for.
    StepCode(const Tape& tape, std::span<const Instruction> instructions, std::span<const Slot> results,
             StepNumberKind numbers);

    /// What it was made from.
    const Tape& tape() const { return *tape_; }
    std::span<const Instruction> instructions() const { return instructions_; }
    /// The stretches in the order they run, the steps of all of them, and those steps that read an argument.
    std::span<const Stretch> stretches() const { return stretches_; }
    std::span<const ProgramStep> steps() const { return steps_; }
    std::span<const std::uint32_t> movable() const { return movable_; }

  private:
    const Tape* tape_;
    std::span<const Instruction> instructions_;
    std::vector<ProgramStep> steps_;
    std::vector<Stretch> stretches_;
    std::vector<std::uint32_t> movable_;
};

/// The codes of one list of instructions, for each kind of number, made when they are first asked for.
/// Several threads may ask at a time.
class StepCodes {
  public:
    /// As for StepCode, and the results must outlive the codes, too.
    StepCodes(const Tape& tape, std::span<const Instruction> instructions, std::span<const Slot> results)
        : tape_(tape), instructions_(instructions), results_(results) {}

    /// The code for numbers of this kind; valid while this object lives.
    const StepCode& of(StepNumberKind numbers) const;

  private:
    const Tape& tape_;
    std::span<const Instruction> instructions_;
    std::span<const Slot> results_;
    mutable std::array<std::once_flag, 3> made_;
    mutable std::array<std::optional<StepCode>, 3> codes_;
};

}  // namespace isoscope
