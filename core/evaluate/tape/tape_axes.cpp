// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/tape/tape_axes.h"

#include <algorithm>

namespace isoscope {

std::vector<std::uint8_t> axesWithout(const Tape& tape, std::span<const std::size_t> left) {
    std::vector<std::uint8_t> slots(tape.slotCount()), all;
    const auto coordinates = static_cast<std::size_t>(std::min(3, tape.argumentCount()));
    for (std::size_t k = 0; k < coordinates; ++k) slots[k] = static_cast<std::uint8_t>(1 << k);
    for (const Instruction& instruction : tape.instructions()) {
        std::uint8_t axes = 0;
        for (std::size_t k = 0; k < instruction.operandCount; ++k) axes |= slots[instruction.operands[k]];
        if (std::ranges::find(left, all.size()) != left.end()) axes = 0;
        slots[instruction.target] = axes;
        all.push_back(axes);
    }
    all.push_back(slots[tape.results()[0]]);
    return all;
}

bool isLinear(const Tape& tape, const Instruction& instruction) {
    switch (instruction.operation) {
        case Operation::negate:
        case Operation::add:
        case Operation::subtract: return true;
        case Operation::multiply:
            return tape.isUniform(instruction.operands[0]) || tape.isUniform(instruction.operands[1]);
        case Operation::divide: return tape.isUniform(instruction.operands[1]);
        default: return false;
    }
}

std::uint8_t gradientAxes(const Tape& tape) {
    struct Axes {
        std::uint8_t all = 0, bent = 0;
    };
    std::vector<Axes> slots(tape.slotCount());
    const auto coordinates = static_cast<std::size_t>(std::min(3, tape.argumentCount()));
    for (std::size_t k = 0; k < coordinates; ++k) slots[k].all = static_cast<std::uint8_t>(1 << k);
    for (const Instruction& instruction : tape.instructions()) {
        Axes axes;
        const auto add = [&](Slot slot) {
            axes.all |= slots[slot].all;
            axes.bent |= slots[slot].bent;
        };
        for (std::size_t k = 0; k < instruction.operandCount; ++k) add(instruction.operands[k]);
        if (instruction.operation == Operation::sum || instruction.operation == Operation::product)
            for (const Slot slot : tape.loop(instruction.index).captured) add(slot);
        if (!isLinear(tape, instruction)) axes.bent = axes.all;
        slots[instruction.target] = axes;
    }
    return slots[tape.results()[0]].bent;
}

}  // namespace isoscope
