// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/evaluate/tape/tape.h"

namespace isoscope {

/// The side that a choice takes wherever it was looked at: of min and max the first or the second operand, of
/// abs its operand or the negative one, of select what stands for less than 0 or for more.
enum class Choice : std::uint8_t { open, first, second };

/// Whether an operation takes the value of one operand or another: min, max, abs and select.
bool isChoice(Operation operation);

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

/// What of the value v of a choosing instruction the tape's result f depends on, as far as only the sign of
/// f - threshold counts: on all of v, on the sign of v - threshold alone, or on that of -v - threshold alone.
/// So it is for the operations of a union, an intersection or a difference.
enum class SignDependence : std::int8_t { value = 0, sign = 1, oppositeSign = -1 };

/// What a tape comes to where some of its choices are decided: fewer instructions on the slots of the tape's
/// workspaces. Valid with the tape it was made from.
struct SimplifiedTape {
    std::vector<Instruction> instructions;
    Slot result = 0;

    /// Where a value comes from: an instruction, or `fixed` and the slot of an argument or constant.
    using Value = std::uint32_t;
    static constexpr Value fixed = 1u << 31;
    /// What each instruction works on, for TapeSimplifier.
    struct Link {
        std::array<Value, 4> operands{};
        std::uint32_t choice = 0;  ///< its number among the choosing instructions, if it is one
    };
    std::vector<Link> links;
    Value resultValue = fixed;
    std::vector<SignDependence> dependences;  ///< of the choosing instructions
};

/// Leaves out of a tape what decided choices make superfluous. After Duff, "Interval arithmetic and recursive
/// subdivision for implicit functions and constructive solid geometry" (1992). One object per thread.
class TapeSimplifier {
  public:
    /// The tape must outlive the simplifier.
    explicit TapeSimplifier(const Tape& tape);

    /// What is shortened from now on: `base`, made from the tape and left alone meanwhile, or the tape itself
    /// for null.
    void setBase(const SimplifiedTape* base) { base_ = base != nullptr ? base : &whole_; }

    /// Number of instructions that choose; 0 also for tapes with loops, which are not shortened.
    std::size_t choiceCount() const { return base_->dependences.size(); }
    /// No decisions leave fewer instructions than these of the tape's first result: those that it needs
    /// whatever min, max and select choose.
    std::size_t leastLength() const;
    /// How the tape's first result depends on each of its choosing instructions, in order.
    std::span<const SignDependence> dependences() const { return base_->dependences; }

    /// The tape's result `result` (a base has but one) with choices[k] made for its k-th choosing
    /// instruction. Linear in what is left and in the decided choices that lead there; `simplifiedTape` keeps
    /// its memory.
    void simplify(std::span<const Choice> choices, std::size_t result, SimplifiedTape& simplifiedTape);
    /// The same for the choices that some lanes (a bit for each) have in common.
    void simplify(std::span<const LaneChoices> choices, std::uint64_t lanes, std::size_t result,
                  SimplifiedTape& simplifiedTape);

  private:
    using Value = SimplifiedTape::Value;
    static bool isFixed(Value value) { return value >= SimplifiedTape::fixed; }

    void linkWhole();
    void findStakes();
    template <class Choose>
    void shortenBy(Choose choose, std::size_t result, SimplifiedTape& simplifiedTape);
    template <class Choose>
    Value follow(Value value, Choose choose) const;
    void need(Value value, std::uint32_t user);
    template <class Choose>
    void markNeeded(Value result, Choose choose);
    void assignSlots(SimplifiedTape& simplifiedTape);
    void append(std::uint32_t source, SimplifiedTape& simplifiedTape);

    const Tape& tape_;
    SimplifiedTape whole_;
    std::vector<Value> results_;  ///< of the whole tape
    const SimplifiedTape* base_ = &whole_;
    // Of the instructions of the base.
    std::vector<std::uint64_t> needed_;  ///< a bit for each
    std::vector<std::array<Value, 4>> operands_;
    std::vector<std::uint8_t> flipped_;   ///< abs that becomes a negation
    std::vector<std::uint32_t> lastUse_;  ///< of its value
    std::vector<std::uint32_t> numbers_;  ///< in the simplified tape
    std::vector<Slot> slots_;
    std::vector<Slot> free_;
};

}  // namespace isoscope
