// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "core/evaluate/tape/tape.h"
#include "core/numeric/interval.h"

namespace isoscope {

/// The side that a choice takes wherever it was looked at: of min and max the first or the second operand, of
/// abs its operand or the negative one, of select what stands for less than 0 or for more, or, of the one
/// that has it, for 0.
enum class Choice : std::uint8_t { open, first, second, atZero };

/// Whether an operation takes the value of one operand or another: min, max, abs and select.
constexpr bool isChoice(Operation operation) {
    switch (operation) {
        case Operation::minimum:
        case Operation::maximum:
        case Operation::absolute:
        case Operation::select3:
        case Operation::select4: return true;
        default: return false;
    }
}

/// Whether an operation takes one operand or another by the sign of its first one.
constexpr bool isSelect(Operation operation) {
    return operation == Operation::select3 || operation == Operation::select4;
}

/// The side of a select that is left where its cases come to the same: that of a constant, which costs
/// nothing.
inline Choice cheapestCase(const Tape& tape, const Instruction& select) {
    const Slot first = select.operands[1], last = select.operands[select.operandCount - 1u];
    return !tape.isUniform(first) && tape.isUniform(last) ? Choice::second : Choice::first;
}

/// Where up to 64 lanes take the sides of one choice: bit i stands for lane i.
struct LaneChoices {
    std::uint64_t first = 0, second = 0;

    /// The side that a lane takes; `open` where it is not decided.
    Choice of(std::size_t lane) const { return ofAll(std::uint64_t(1) << lane); }
    /// The side that all of several lanes (a bit for each) take; `open` where they differ or one is not
    /// decided.
    Choice ofAll(std::uint64_t lanes) const {
        if ((first & lanes) == lanes) return Choice::first;
        return (second & lanes) == lanes ? Choice::second : Choice::open;
    }
};

/// A number between value - reach and value + reach.
struct SignLevel {
    double value = 0;
    double reach = 0;

    /// Whether it is below all values of an interval, or above, by more than values as doubles are off; false
    /// where some may be undefined.
    bool isBelow(const Interval& values) const {
        return values.isDefined() && value + reach + roundings(values.low) < values.low;
    }
    bool isAbove(const Interval& values) const {
        return values.isDefined() && values.high + roundings(values.high) < value - reach;
    }

  private:
    double roundings(double other) const { return 1e-15 * (std::abs(value) + reach + std::abs(other)); }
};

/// What an evaluation is for when only the sign of the result minus a threshold matters. For a choosing
/// instruction of a union, an intersection or a difference, and for cases of cases, that sign depends on the
/// value v of the instruction by the sign of v - level alone; a level is the threshold, or what it comes to
/// behind negations and numbers that are added or multiplied by.
struct SignStakes {
    std::span<const SignLevel> levels;            ///< TapeLinks::levels()
    std::span<const std::uint32_t> levelNumbers;  ///< TapeSimplifier::levelNumbers()

    /// The level of the k-th choosing instruction; null where all of its value counts.
    const SignLevel* of(std::size_t k) const {
        return levelNumbers.empty() || levelNumbers[k] == 0 ? nullptr : &levels[levelNumbers[k]];
    }
};

/// What a tape comes to where some of its choices are decided: fewer instructions on the slots of the tape's
/// workspaces. Valid with the tape it was made from.
struct SimplifiedTape {
    std::vector<Instruction> instructions;
    Slot result = 0;

    /// Where a value comes from: an instruction, or `fixed` and the slot of an argument or constant.
    using Value = std::uint32_t;
    static constexpr Value fixed = 1u << 31;
    static bool isFixed(Value value) { return value >= fixed; }
    /// What each instruction works on, for TapeSimplifier.
    struct Link {
        std::array<Value, 4> operands{};
        std::uint32_t choice = 0;  ///< its number among the choosing instructions, if it is one
    };
    std::vector<Link> links;
    Value resultValue = fixed;
    /// Of the choosing instructions, as numbers of TapeLinks::levels(); 0 where all of a value counts.
    std::vector<std::uint32_t> levelNumbers;
};

}  // namespace isoscope
