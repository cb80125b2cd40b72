// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/evaluate/tape/simplified_tape.h"
#include "core/evaluate/tape/tape.h"

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
    /// No decisions leave fewer instructions than these of the tape's first result: those that it needs
    /// whatever min, max and select choose.
    std::size_t leastLength() const { return leastLength_; }

  private:
    void linkWhole();
    void findStakes();
    std::size_t countLeast() const;

    const Tape& tape_;
    SimplifiedTape whole_;
    std::vector<SimplifiedTape::Value> results_;
    std::size_t leastLength_ = 0;
};

}  // namespace isoscope
