// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/evaluate/tape.h"

namespace isoscope {

/// What a tape comes to where some of its choices are decided: fewer instructions on the slots of the tape's
/// workspaces. Valid with the tape it was made from.
struct ShortTape {
    std::vector<Instruction> instructions;
    Slot result = 0;
};

/// The side that a choice takes wherever it was looked at: of min and max the first or the second operand, of
/// abs its operand or the negative one, of select what stands for less than 0 or for more.
enum class Choice : std::uint8_t { open, first, second };

bool isChoice(Operation operation);

/// Leaves out of a tape what decided choices make superfluous. After Duff, "Interval arithmetic and recursive
/// subdivision for implicit functions and constructive solid geometry" (1992). One object per thread.
class TapeShortener {
  public:
    /// The tape must outlive the shortener.
    explicit TapeShortener(const Tape& tape);

    /// What is shortened from now on: `base`, made from the tape by this object and left alone meanwhile, or
    /// the tape itself for null.
    void setBase(const ShortTape* base);

    /// Number of instructions that choose; 0 also for tapes with loops, which are not shortened.
    std::size_t choiceCount() const { return choiceCount_; }

    /// The tape's result `result` (a base has but one) with choices[k] made for its k-th choosing
    /// instruction. Linear in the instructions; `shortTape` keeps its memory.
    void shorten(std::span<const Choice> choices, std::size_t result, ShortTape& shortTape);

  private:
    /// Where a value comes from: the index of an instruction, or of a fixed slot behind all instructions.
    using Value = std::uint32_t;

    void resolve(std::span<const Choice> choices);
    void markNeeded(Value result);
    void assignSlots(ShortTape& shortTape);
    bool isFixed(Value value) const { return value >= instructions_.size(); }
    Slot slotOf(Value value) const;

    const Tape& tape_;
    const ShortTape* base_ = nullptr;
    std::span<const Instruction> instructions_;  ///< of base or tape
    std::size_t choiceCount_ = 0;
    std::vector<Value> current_;         ///< of each slot, while walking along the tape
    std::vector<Instruction> resolved_;  ///< with values instead of slots, and without decided choices
    std::vector<std::uint8_t> dropped_;
    std::vector<std::uint32_t> lastUse_;  ///< of each instruction's value; 0 when there is none
    std::vector<Slot> slots_;
    std::vector<Slot> free_;
};

}  // namespace isoscope
