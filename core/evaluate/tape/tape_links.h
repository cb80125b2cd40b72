// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/evaluate/tape/simplified_tape.h"
#include "core/evaluate/tape/tape.h"
#include "core/evaluate/tape/uniform_values.h"

namespace isoscope {

/// Where the values in a tape come from, whatever slots they go through, and its choices: what all
/// TapeSimplifiers of the tape share. Immutable.
class TapeLinks {
  public:
    /// The tape must have a result, and outlive the links.
    explicit TapeLinks(const Tape& tape);

    /// What it was made from.
    const Tape& tape() const { return tape_; }
    /// The tape itself, with its first result.
    const SimplifiedTape& whole() const { return whole_; }
    /// What each result of the tape comes from.
    const std::vector<SimplifiedTape::Value>& results() const { return results_; }
    /// The levels of SignStakes for a threshold of the first result, by their numbers; number 0 is for none.
    std::vector<SignLevel> levels(const UniformValues& uniforms, double threshold) const;
    /// No decisions leave fewer instructions than these of the tape's first result: those that it needs
    /// whatever min, max and select choose.
    std::size_t leastLength() const { return leastLength_; }

    /// An order of the choosing instructions in which those of a chain, min(min(min(a, b), c), d), stand side
    /// by side, so that a search for what is left of a long union passes many at once.
    struct Chains {
        std::vector<std::uint32_t> places;        ///< of each choosing instruction, by its number
        std::vector<std::uint32_t> instructions;  ///< place by place
        /// A bit for each place: whether the first, or the second, operand is what stands one place before.
        std::vector<std::uint64_t> leadsByFirst, leadsBySecond;
    };
    /// Of all choosing instructions; empty for tapes with loops.
    const Chains& chains() const { return chains_; }

  private:
    /// A level, by another one: what `operation` is compared with, of whose operands one is the value whose
    /// level this is, and the other one, if any, a uniform slot.
    struct LevelStep {
        std::uint32_t from = 0;
        Operation operation = Operation::negate;
        Slot uniform = 0;
        bool uniformFirst = false;
    };

    void linkWhole();
    void findLevels();
    std::optional<LevelStep> levelStep(std::size_t instruction) const;
    std::size_t countLeast() const;
    void findChains();

    const Tape& tape_;
    SimplifiedTape whole_;
    std::vector<SimplifiedTape::Value> results_;
    std::vector<LevelStep> levelSteps_;  ///< from number 2 on; number 1 is the threshold
    std::size_t leastLength_ = 0;
    Chains chains_;
};

}  // namespace isoscope
