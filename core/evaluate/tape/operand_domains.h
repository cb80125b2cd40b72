// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

namespace isoscope {

class IntervalEvaluator;
class Tape;

/// What the first two operands of each instruction of a tape can be wherever the point is. `loops` are those
/// of the loops' bodies, in order.
struct OperandDomains {
    /// Low and high of the first operand, then of the second.
    using Limits = std::array<double, 4>;
    std::vector<Limits> limits;
    std::vector<OperandDomains> loops;

    OperandDomains() = default;
    /// `everywhere` has just enclosed the tape for all arguments there may be.
    OperandDomains(const Tape& tape, const IntervalEvaluator& everywhere);
};

}  // namespace isoscope
