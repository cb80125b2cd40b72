// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/jumps/affine_cases.h"

#include <algorithm>
#include <limits>
#include <map>
#include <tuple>

namespace isoscope {

namespace {

/// The operation whose jumps are those of this one on the same value; none (count_) for those that share
/// none.
Operation sharedAs(Operation operation) {
    switch (operation) {
        case Operation::select3:
        case Operation::select4:
        case Operation::floor: return operation;
        case Operation::fraction: return Operation::floor;
        default: return Operation::count_;
    }
}

bool isArithmetic(Operation operation) {
    return operation == Operation::add || operation == Operation::subtract ||
           operation == Operation::multiply || operation == Operation::divide;
}

/// Operations that make whole numbers of whole numbers whatever they are run as.
bool keepsWhole(Operation operation) {
    return operation == Operation::negate || operation == Operation::absolute ||
           operation == Operation::minimum || operation == Operation::maximum;
}

}  // namespace

std::vector<bool> findWholeNumbers(const Tape& tape, std::span<const Instruction> instructions) {
    std::vector<bool> found(instructions.size()), whole(tape.slotCount());
    for (std::size_t i = 0; i < instructions.size(); ++i) {
        const Instruction& instruction = instructions[i];
        const Operation operation = instruction.operation;
        const auto operands = std::span(instruction.operands).first(instruction.operandCount);
        const bool all = std::all_of(operands.begin(), operands.end(),
                                     [&](Slot slot) { return tape.isUniform(slot) || whole[slot]; });
        found[i] = all && isArithmetic(operation);
        whole[instruction.target] = found[i] || hasSides(operation) || (all && keepsWhole(operation));
    }
    return found;
}

std::vector<bool> wholeNumbersByNumber(const Tape& tape, std::span<const Instruction> instructions) {
    const std::vector<bool> whole = findWholeNumbers(tape, instructions);
    std::vector<bool> byNumber;
    for (std::size_t k = 0; k < whole.size(); ++k) {
        const std::size_t number = instructions[k].number;
        if (byNumber.size() <= number) byNumber.resize(number + 1);
        byNumber[number] = whole[k];
    }
    return byNumber;
}

std::vector<std::uint32_t> numberJumps(std::span<const Instruction> instructions) {
    // Who has written a slot last tells values apart; an argument is what its slot held before, writer 0.
    std::map<Slot, std::uint32_t> writers;
    std::map<std::tuple<Operation, Slot, std::uint32_t>, std::uint32_t> shared;
    std::vector<std::uint32_t> jumpOf;
    std::uint32_t jumps = 0;
    for (std::uint32_t k = 0; k < instructions.size(); ++k) {
        const Instruction& instruction = instructions[k];
        const Operation operation = instruction.operation;
        if (jumpOf.size() <= instruction.number)
            jumpOf.resize(instruction.number + 1, CaseLanes::notNumbered);
        if (hasSides(operation)) {
            std::uint32_t jump = jumps;
            const Slot condition = instruction.operands[0];
            if (const Operation kind = sharedAs(operation); kind != Operation::count_)
                jump = shared.try_emplace({kind, condition, writers[condition]}, jumps).first->second;
            jumpOf[instruction.number] = jump;
            jumps = std::max(jumps, jump + 1);
        }
        writers[instruction.target] = k + 1;
    }
    return jumpOf;
}

void prepareCases(const Tape& tape, std::span<const Instruction> instructions, CaseLanes& cases) {
    cases.jumpOf = numberJumps(instructions);
    cases.isWhole = wholeNumbersByNumber(tape, instructions);
    std::uint32_t jumps = 0;
    for (const std::uint32_t jump : cases.jumpOf)
        if (jump != CaseLanes::notNumbered) jumps = std::max(jumps, jump + 1);
    cases.sides.resize(jumps);
    for (CaseLanes::Lanes& sides : cases.sides) sides.fill(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace isoscope
