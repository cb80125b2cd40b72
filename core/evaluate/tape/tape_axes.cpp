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

}  // namespace isoscope
