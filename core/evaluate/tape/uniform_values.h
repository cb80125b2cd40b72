// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/evaluate/tape/tape.h"

namespace isoscope {

/// The uniform part of a tape for one set of parameter values, computed once: values[k] is that of uniform
/// slot firstUniform() + k. `loops` are those of the loops' bodies, in order.
struct UniformValues {
    std::vector<double> values;
    std::vector<UniformValues> loops;

    /// Missing parameters count as 0.
    UniformValues(const Tape& tape, std::span<const double> parameters);

    /// The value of a uniform slot of `tape`, which these are for.
    double of(const Tape& tape, Slot slot) const { return values[slot - tape.firstUniform()]; }
    /// Whether all are the same, bit by bit: then so is the function.
    bool sameAs(const UniformValues& other) const;
};

}  // namespace isoscope
