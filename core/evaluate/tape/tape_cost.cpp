// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/tape/tape_cost.h"

#include <algorithm>

namespace isoscope {

namespace {

bool containsNoise(const Tape& tape) {
    const auto isNoise = [](const Instruction& instruction) {
        return instruction.operation == Operation::noise || isVectorNoise(instruction.operation);
    };
    return std::any_of(tape.instructions().begin(), tape.instructions().end(), isNoise) ||
           std::any_of(tape.loops().begin(), tape.loops().end(),
                       [](const TapeLoop& loop) { return containsNoise(*loop.body); });
}

}  // namespace

TapeCost::TapeCost(const Tape& tape)
    : holdsNoise(containsNoise(tape)),
      cheap(tape.loops().empty() && tape.instructions().size() <= 10 && !holdsNoise),
      isLong(!tape.loops().empty() || tape.instructions().size() > 40) {}

}  // namespace isoscope
