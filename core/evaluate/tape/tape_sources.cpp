// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/tape/tape_sources.h"

#include <numeric>

namespace isoscope {

std::vector<std::array<TapeSource, 4>> operandSources(const Tape& tape) {
    std::vector<std::array<TapeSource, 4>> all(tape.instructions().size());
    std::vector<TapeSource> slots(tape.slotCount());
    std::iota(slots.begin(), slots.end(), TapeSource{0});
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Instruction& instruction = tape.instructions()[i];
        for (std::size_t k = 0; k < instruction.operandCount; ++k) all[i][k] = slots[instruction.operands[k]];
        slots[instruction.target] = tape.slotCount() + i;
    }
    return all;
}

}  // namespace isoscope
