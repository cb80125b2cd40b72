// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/evaluate/tape/simplified_tape.h"
#include "core/evaluate/tape/uniform_values.h"
#include "core/numeric/interval.h"
#include "core/roots/root_settings.h"

namespace isoscope {

/// Finds where the result of a tape can be what is wanted by going backwards through it, from the result to
/// x, y and z. After Benhamou, Goualard, Granvilliers and Puget, "Revising hull and box consistency" (1999).
/// One object per thread.
class BackwardBounds {
  public:
    /// Where a result is as wanted.
    struct Box {
        LineRegion region;  ///< empty, low above high, where the result is nowhere so
        /// Whether there is nothing to be gained by a closer look: each value is used once, by an operation
        /// that can be gone through.
        bool isTight = false;
    };

    /// Both must outlive the bounds; the tape is one without loops.
    BackwardBounds(const Tape& tape, const UniformValues& uniforms) : tape_(tape), uniforms_(uniforms) {}

    /// The part of the region in which a shortened tape, whose links are there, can have a result within
    /// `wanted`. A good guess and no proof: values of points as doubles are off by their roundings.
    Box where(const SimplifiedTape& tape, const Interval& wanted, const LineRegion& region);

  private:
    using Value = SimplifiedTape::Value;

    bool isUniform(Value value) const;
    std::size_t placeOf(Value value) const;
    Interval valueOf(Value value) const;
    void narrow(Value value, const Interval& to);
    void use(Value value);
    Interval goForward(const SimplifiedTape& tape, std::size_t instruction);
    void goBack(const SimplifiedTape& tape, std::size_t instruction);

    const Tape& tape_;
    const UniformValues& uniforms_;
    // Of the arguments, then of the instructions.
    std::vector<Interval> values_;
    std::vector<bool> isUsed_;
    bool isTight_ = false;
};

}  // namespace isoscope
