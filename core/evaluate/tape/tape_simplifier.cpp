// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/tape/tape_simplifier.h"

#include <bit>

namespace isoscope {

namespace {

constexpr std::size_t wordBits = 64;

/// The operand that a decided choice comes to.
std::size_t chosenOperand(Operation operation, Choice choice) {
    const bool first = choice == Choice::first;
    switch (operation) {
        case Operation::select3: return first ? 1 : 2;
        case Operation::select4: return first ? 1 : choice == Choice::atZero ? 2 : 3;
        case Operation::absolute: return 0;
        default: return first ? 0 : 1;
    }
}

bool becomesNegation(Operation operation, Choice choice) {
    return operation == Operation::absolute && choice == Choice::second;
}

}  // namespace

void TapeSimplifier::simplify(std::span<const Choice> choices, std::size_t result,
                              SimplifiedTape& simplifiedTape) {
    shortenBy([choices](std::uint32_t choice) { return choices[choice]; }, result, simplifiedTape);
}

void TapeSimplifier::simplify(std::span<const LaneChoices> choices, std::uint64_t lanes, std::size_t result,
                              SimplifiedTape& simplifiedTape) {
    shortenBy([choices, lanes](std::uint32_t choice) { return choices[choice].ofAll(lanes); }, result,
              simplifiedTape);
}

template <class Choose>
void TapeSimplifier::shortenBy(Choose choose, std::size_t result, SimplifiedTape& simplifiedTape) {
    makeRoom();
    const auto chosen = [&](std::uint32_t i) {
        return choiceCount() > 0 && isChoice(base_->instructions[i].operation)
                   ? choose(base_->links[i].choice)
                   : Choice::open;
    };
    const Value value =
        follow(base_ == &links_.whole() ? links_.results()[result] : base_->resultValue, chosen);
    markNeeded(value, chosen);
    assignSlots(simplifiedTape);
    simplifiedTape.resultValue = SimplifiedTape::isFixed(value) ? value : numbers_[value];
    simplifiedTape.result = SimplifiedTape::isFixed(value) ? value - SimplifiedTape::fixed : slots_[value];
}

void TapeSimplifier::makeRoom() {
    if (!needed_.empty()) return;
    const std::size_t count = links_.whole().instructions.size();
    needed_.resize(count / wordBits + 1);
    operands_.resize(count);
    flipped_.resize(count);
    lastUse_.resize(count);
    numbers_.resize(count);
    slots_.resize(count);
}

/// What a value comes to if it is that of a decided choice.
template <class Choose>
TapeSimplifier::Value TapeSimplifier::follow(Value value, Choose choose) const {
    while (!SimplifiedTape::isFixed(value)) {
        const Choice choice = choose(value);
        const Operation operation = base_->instructions[value].operation;
        if (choice == Choice::open || becomesNegation(operation, choice)) break;
        value = base_->links[value].operands[chosenOperand(operation, choice)];
    }
    return value;
}

void TapeSimplifier::need(Value value, std::uint32_t user) {
    if (SimplifiedTape::isFixed(value)) return;
    std::uint64_t& word = needed_[value / wordBits];
    const std::uint64_t bit = std::uint64_t(1) << value % wordBits;
    // The last user comes first.
    if ((word & bit) == 0) lastUse_[value] = user;
    word |= bit;
}

template <class Choose>
void TapeSimplifier::markNeeded(Value result, Choose choose) {
    const auto end = static_cast<std::uint32_t>(base_->instructions.size());
    std::fill_n(needed_.begin(), end / wordBits + 1, 0);
    need(result, end);
    for (std::size_t word = end / wordBits + 1; word-- > 0;) {
        // Operands stand before what uses them, maybe in the same word.
        for (std::uint64_t below = ~std::uint64_t(0); (needed_[word] & below) != 0;) {
            const auto bit = static_cast<int>(std::bit_width(needed_[word] & below)) - 1;
            below = (std::uint64_t(1) << bit) - 1;
            const auto i = static_cast<std::uint32_t>(word * wordBits) + static_cast<std::uint32_t>(bit);
            const Instruction& instruction = base_->instructions[i];
            flipped_[i] = becomesNegation(instruction.operation, choose(i));
            for (std::size_t k = 0; k < instruction.operandCount; ++k) {
                operands_[i][k] = follow(base_->links[i].operands[k], choose);
                need(operands_[i][k], i);
            }
        }
    }
}

void TapeSimplifier::assignSlots(SimplifiedTape& simplifiedTape) {
    simplifiedTape.instructions.clear();
    simplifiedTape.links.clear();
    simplifiedTape.levelNumbers.clear();
    free_.clear();
    Slot next = links_.tape().firstReused();
    const std::size_t words = base_->instructions.size() / wordBits + 1;
    std::size_t left = 0;
    for (std::size_t word = 0; word < words; ++word)
        left += static_cast<std::size_t>(std::popcount(needed_[word]));
    simplifiedTape.instructions.reserve(left);
    simplifiedTape.links.reserve(left);
    for (std::size_t word = 0; word < words; ++word) {
        for (std::uint64_t bits = needed_[word]; bits != 0; bits &= bits - 1) {
            const auto i = static_cast<std::uint32_t>(word * wordBits) +
                           static_cast<std::uint32_t>(std::countr_zero(bits));
            append(i, simplifiedTape);
            if (free_.empty()) {
                slots_[i] = next++;
            } else {
                slots_[i] = free_.back();
                free_.pop_back();
            }
            simplifiedTape.instructions.back().target = slots_[i];
        }
    }
}

/// Instruction `source` of the base, on slots; those that it is the last to use become free.
void TapeSimplifier::append(std::uint32_t source, SimplifiedTape& simplifiedTape) {
    numbers_[source] = static_cast<std::uint32_t>(simplifiedTape.instructions.size());
    Instruction& instruction = simplifiedTape.instructions.emplace_back(base_->instructions[source]);
    SimplifiedTape::Link& link = simplifiedTape.links.emplace_back();
    if (flipped_[source]) {
        instruction.operation = Operation::negate;
    } else if (choiceCount() > 0 && isChoice(instruction.operation)) {
        link.choice = static_cast<std::uint32_t>(simplifiedTape.levelNumbers.size());
        simplifiedTape.levelNumbers.push_back(base_->levelNumbers[base_->links[source].choice]);
    }
    for (std::size_t k = 0; k < instruction.operandCount; ++k) {
        const Value value = operands_[source][k];
        if (SimplifiedTape::isFixed(value)) {
            link.operands[k] = value;
            instruction.operands[k] = value - SimplifiedTape::fixed;
            continue;
        }
        link.operands[k] = numbers_[value];
        instruction.operands[k] = slots_[value];
        if (lastUse_[value] != source) continue;
        free_.push_back(slots_[value]);
        // The same value may be both operands: its slot is free once.
        lastUse_[value] = static_cast<std::uint32_t>(base_->instructions.size());
    }
}

}  // namespace isoscope
