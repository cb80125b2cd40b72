// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/tape/shared_roots.h"

#include <algorithm>
#include <utility>

namespace isoscope {

std::vector<std::size_t> sharedRoots(const Tape& tape) {
    constexpr int several = 2;
    // In how many ways result 0 depends on a slot, from the last instruction to the first.
    std::vector<int> ways(tape.slotCount());
    const auto add = [&](Slot slot, int more) { ways[slot] = std::min(several, ways[slot] + more); };
    add(tape.results()[0], 1);
    std::vector<std::size_t> roots;
    bool isShared = false;
    for (std::size_t i = tape.instructions().size(); i-- > 0;) {
        const Instruction& instruction = tape.instructions()[i];
        const int here = std::exchange(ways[instruction.target], 0);
        if (here == 0) continue;
        if (instruction.operation == Operation::squareRoot) {
            roots.push_back(i);
            isShared = isShared || here == several;
            continue;
        }
        for (std::size_t k = 0; k < instruction.operandCount; ++k) add(instruction.operands[k], here);
        if (instruction.operation == Operation::sum || instruction.operation == Operation::product)
            for (const Slot slot : tape.loop(instruction.index).captured) add(slot, several);
    }
    if (!isShared) roots.clear();
    std::ranges::reverse(roots);
    return roots;
}

}  // namespace isoscope
