// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/certified/tape_cost.h"

#include <algorithm>

namespace isoscope {

bool holdsNoise(const Tape& tape) {
    const auto isNoise = [](const Instruction& instruction) {
        const Operation operation = instruction.operation;
        return operation == Operation::noise || operation == Operation::noiseGradientX ||
               operation == Operation::noiseGradientY || operation == Operation::noiseGradientZ;
    };
    return std::any_of(tape.instructions().begin(), tape.instructions().end(), isNoise) ||
           std::any_of(tape.loops().begin(), tape.loops().end(),
                       [](const TapeLoop& loop) { return holdsNoise(*loop.body); });
}

bool isCheap(const Tape& tape) {
    return tape.loops().empty() && tape.instructions().size() <= 10 && !holdsNoise(tape);
}

}  // namespace isoscope
