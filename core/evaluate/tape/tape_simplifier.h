// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/evaluate/tape/simplified_tape.h"
#include "core/evaluate/tape/tape_links.h"

namespace isoscope {

/// Which choosing instructions of a tape are decided, a bit for each of their places (TapeLinks::Chains).
struct DecidedChoices {
    std::vector<std::uint64_t> first, second;

    /// What is decided at a place.
    Choice of(std::uint32_t place) const;
    /// None.
    void reset(const TapeLinks& links);
    /// Those, too, that some lanes (a bit for each) have in common in `choices`, those of the choosing
    /// instructions at `places`.
    void add(std::span<const std::uint32_t> places, std::span<const LaneChoices> choices,
             std::uint64_t lanes);
};

/// Leaves out of a tape what decided choices make superfluous. After Duff, "Interval arithmetic and recursive
/// subdivision for implicit functions and constructive solid geometry" (1992). One object per thread.
class TapeSimplifier {
  public:
    /// The links must outlive the simplifier.
    explicit TapeSimplifier(const TapeLinks& links) : links_(links), base_(&links.whole()) {}

    /// What is shortened from now on: `base`, made from the tape and left alone meanwhile, or the tape itself
    /// for null.
    void setBase(const SimplifiedTape* base) { base_ = base != nullptr ? base : &links_.whole(); }

    /// Number of instructions that choose; 0 also for tapes with loops, which are not shortened.
    std::size_t choiceCount() const { return base_->levelNumbers.size(); }
    /// For SignStakes: of each of its choosing instructions, in order.
    std::span<const std::uint32_t> levelNumbers() const { return base_->levelNumbers; }

    /// The tape's result `result` (a base has but one) with choices[k] made for its k-th choosing
    /// instruction. Linear in what is left and in the decided choices that lead there; `simplifiedTape` keeps
    /// its memory.
    void simplify(std::span<const Choice> choices, std::size_t result, SimplifiedTape& simplifiedTape);
    /// The same for the choices that some lanes (a bit for each) have in common.
    void simplify(std::span<const LaneChoices> choices, std::uint64_t lanes, std::size_t result,
                  SimplifiedTape& simplifiedTape);
    /// How many instructions simplify() would leave.
    std::size_t countLeft(std::span<const Choice> choices, std::size_t result);
    /// The same for choices of the whole tape, whatever the base is, and its first result.
    void simplify(const DecidedChoices& choices, SimplifiedTape& simplifiedTape);

  private:
    using Value = SimplifiedTape::Value;

    void makeRoom();
    Value resultOf(std::size_t result) const {
        return base_ == &links_.whole() ? links_.results()[result] : base_->resultValue;
    }
    template <class Decided>
    void shortenBy(const Decided& decisions, std::size_t result, SimplifiedTape& simplifiedTape);
    void need(Value value, std::uint32_t user);
    template <class Decided>
    void markNeeded(Value result, const Decided& decisions);
    std::size_t countNeeded() const;
    void assignSlots(SimplifiedTape& simplifiedTape);
    void append(std::uint32_t source, SimplifiedTape& simplifiedTape);

    const TapeLinks& links_;
    const SimplifiedTape* base_;
    // Of the instructions of the base; there is room once something is shortened.
    std::vector<std::uint64_t> needed_;        ///< a bit for each; none between calls
    std::size_t firstWord_ = 0, endWord_ = 0;  ///< of what is needed
    std::vector<std::array<Value, 4>> operands_;
    std::vector<std::uint8_t> flipped_;   ///< abs that becomes a negation
    std::vector<std::uint32_t> lastUse_;  ///< of its value
    std::vector<std::uint32_t> numbers_;  ///< in the simplified tape
    std::vector<Slot> slots_;
    std::vector<Slot> free_;
};

}  // namespace isoscope
