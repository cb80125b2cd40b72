// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "core/evaluate/tape/tape.h"

namespace isoscope {

/// What decides a choice (min, max, abs, select) of a tape: the sign of a difference. min(a, b) and |a - b|
/// are decided by the same one.
struct LinkedChoice {
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    std::size_t first = none;  ///< the first instruction that the difference decides, if not this one
    bool reversed = false;     ///< whether this one takes its second side where that takes its first
};

/// By instruction. Sides are counted as in IntervalGradientEvaluator::evaluatePiece().
std::vector<LinkedChoice> linkedChoices(const Tape& tape);

}  // namespace isoscope
