// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/algebra/affine_cases.h"

#include <algorithm>
#include <map>
#include <utility>

namespace isoscope {

void setShared(std::span<const Instruction> instructions, CaseLanes& cases) {
    // Who has written a slot last tells values apart; arguments and uniform slots have no writer.
    std::map<Slot, std::uint32_t> writers;
    std::map<std::pair<Operation, std::uint32_t>, std::vector<std::uint32_t>> selects;
    std::uint32_t length = 0;
    for (std::uint32_t k = 0; k < instructions.size(); ++k) {
        const Instruction& instruction = instructions[k];
        length = std::max(length, instruction.number + 1);
        const Operation operation = instruction.operation;
        const auto writer = writers.find(instruction.operands[0]);
        if ((operation == Operation::select3 || operation == Operation::select4) && writer != writers.end())
            selects[{operation, writer->second}].push_back(instruction.number);
        writers[instruction.target] = k;
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
