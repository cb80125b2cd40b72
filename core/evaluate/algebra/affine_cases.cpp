// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/algebra/affine_cases.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace isoscope {

void setShared(std::span<const Instruction> instructions, CaseLanes& cases) {
    // Who has written a slot last tells values apart; an argument is what its slot held before, writer 0.
    std::map<Slot, std::uint32_t> writers;
    std::map<std::tuple<Operation, Slot, std::uint32_t>, std::vector<std::uint32_t>> selects;
    std::uint32_t length = 0;
    for (std::uint32_t k = 0; k < instructions.size(); ++k) {
        const Instruction& instruction = instructions[k];
        length = std::max(length, instruction.number + 1);
        const Operation operation = instruction.operation;
        const Slot condition = instruction.operands[0];
        if (operation == Operation::select3 || operation == Operation::select4)
            selects[{operation, condition, writers[condition]}].push_back(instruction.number);
        writers[instruction.target] = k + 1;
    }
    cases.shared.assign(length, {});
    std::uint32_t conditions = 0;
    for (const auto& [condition, numbers] : selects) {
        if (numbers.size() < 2) continue;
        ++conditions;
        for (const std::uint32_t number : numbers)
            cases.shared[number] = {conditions, number == numbers.front()};
    }
    cases.taken.resize(conditions + 1);
}

}  // namespace isoscope
