// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/tape/tape_likeness.h"

#include <algorithm>

namespace isoscope {

namespace {

bool sameInstruction(const Instruction& a, const Instruction& b) {
    return a.operation == b.operation && a.operandCount == b.operandCount && a.target == b.target &&
           a.operands == b.operands && a.index == b.index;
}

bool sameLoop(const TapeLoop& a, const TapeLoop& b) {
    return a.captured == b.captured && sameCode(*a.body, *b.body);
}

}  // namespace

bool sameCode(const Tape& a, const Tape& b) {
    if (&a == &b) return true;
    const bool sameShape = a.argumentCount() == b.argumentCount() && a.slotCount() == b.slotCount() &&
                           a.uniformCount() == b.uniformCount() &&
                           std::ranges::equal(a.results(), b.results()) &&
                           std::ranges::equal(a.instructions(), b.instructions(), sameInstruction);
    if (!sameShape) return false;
    for (const Instruction& instruction : a.instructions())
        if (instruction.operation == Operation::crackle &&
            !(a.crackle(instruction.index) == b.crackle(instruction.index)))
            return false;
    return std::ranges::equal(a.loops(), b.loops(), sameLoop);
}

}  // namespace isoscope
