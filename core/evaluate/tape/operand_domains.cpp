// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/tape/operand_domains.h"

#include <algorithm>

#include "core/evaluate/interval_evaluator.h"
#include "core/evaluate/tape/tape.h"

namespace isoscope {

OperandDomains::OperandDomains(const Tape& tape, const IntervalEvaluator& everywhere)
    : limits(tape.instructions().size(),
             {-Interval::infinite, Interval::infinite, -Interval::infinite, Interval::infinite}) {
    const std::span<const Instruction> instructions = tape.instructions();
    for (std::size_t number = 0; number < instructions.size(); ++number)
        for (int k = 0; k < std::min<int>(instructions[number].operandCount, 2); ++k) {
            const Interval& range = everywhere.operandRange(number, k);
            // An operand that never has a value needs no limits.
            if (range.empty()) continue;
            limits[number][2 * k] = range.low;
            limits[number][2 * k + 1] = range.high;
        }
    for (std::uint32_t k = 0; k < tape.loops().size(); ++k)
        loops.emplace_back(*tape.loop(k).body, everywhere.loop(k));
}

}  // namespace isoscope
