// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/algebra/affine_cases.h"

#include <algorithm>
#include <limits>
#include <map>
#include <tuple>

namespace isoscope {

namespace {

/// The operation whose jumps are those of this one on the same value; none (count_) for those that share none.
Operation sharedAs(Operation operation) {
    switch (operation) {
        case Operation::select3:
        case Operation::select4:
        case Operation::floor: return operation;
        case Operation::fraction: return Operation::floor;
        default: return Operation::count_;
    }
}

}  // namespace

void prepareCases(std::span<const Instruction> instructions, CaseLanes& cases) {
    // Who has written a slot last tells values apart; an argument is what its slot held before, writer 0.
    std::map<Slot, std::uint32_t> writers;
    std::map<std::tuple<Operation, Slot, std::uint32_t>, std::uint32_t> shared;
    std::uint32_t jumps = 0;
    cases.jumpOf.clear();
    for (std::uint32_t k = 0; k < instructions.size(); ++k) {
        const Instruction& instruction = instructions[k];
        const Operation operation = instruction.operation;
        if (cases.jumpOf.size() <= instruction.number)
            cases.jumpOf.resize(instruction.number + 1, CaseLanes::notNumbered);
        if (hasSides(operation)) {
            std::uint32_t jump = jumps;
            const Slot condition = instruction.operands[0];
            if (const Operation kind = sharedAs(operation); kind != Operation::count_)
                jump = shared.try_emplace({kind, condition, writers[condition]}, jumps).first->second;
            cases.jumpOf[instruction.number] = jump;
            jumps = std::max(jumps, jump + 1);
        }
        writers[instruction.target] = k + 1;
    }
    cases.sides.resize(jumps);
    for (CaseLanes::Lanes& sides : cases.sides) sides.fill(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace isoscope
