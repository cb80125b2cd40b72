// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/tape_shortener.h"

#include <algorithm>

namespace isoscope {

namespace {

constexpr std::uint32_t unused = 0;

/// The operand that a decided choice comes to.
int chosenOperand(Operation operation, Choice choice) {
    const bool first = choice == Choice::first;
    switch (operation) {
        case Operation::select3: return first ? 1 : 2;
        case Operation::select4: return first ? 1 : 3;
        case Operation::absolute: return 0;
        default: return first ? 0 : 1;
    }
}

}  // namespace

bool isChoice(Operation operation) {
    switch (operation) {
        case Operation::minimum:
        case Operation::maximum:
        case Operation::absolute:
        case Operation::select3:
        case Operation::select4: return true;
        default: return false;
    }
}

TapeShortener::TapeShortener(const Tape& tape)
    : tape_(tape),
      current_(tape.slotCount()),
      resolved_(tape.instructions().size()),
      dropped_(tape.instructions().size()),
      lastUse_(tape.instructions().size()),
      slots_(tape.instructions().size()) {
    setBase(nullptr);
}

void TapeShortener::setBase(const ShortTape* base) {
    base_ = base;
    instructions_ = base != nullptr ? base->instructions : tape_.instructions();
    // All but operations and operands stays as it is.
    std::copy(instructions_.begin(), instructions_.end(), resolved_.begin());
    choiceCount_ = 0;
    if (!tape_.loops().empty()) return;
    for (const Instruction& instruction : instructions_) choiceCount_ += isChoice(instruction.operation);
}

void TapeShortener::shorten(std::span<const Choice> choices, std::size_t result, ShortTape& shortTape) {
    resolve(choices);
    const Value value = current_[base_ != nullptr ? base_->result : tape_.results()[result]];
    markNeeded(value);
    assignSlots(shortTape);
    shortTape.result = slotOf(value);
}

/// Follows the values through the slots, which the tape uses again and again.
void TapeShortener::resolve(std::span<const Choice> choices) {
    const std::span<const Instruction> instructions = instructions_;
    for (Slot slot = 0; slot < current_.size(); ++slot)
        current_[slot] = static_cast<Value>(instructions.size()) + slot;
    std::size_t choiceNumber = 0;
    for (std::size_t i = 0; i < instructions.size(); ++i) {
        const Instruction& source = instructions[i];
        Instruction& instruction = resolved_[i];
        instruction.operation = source.operation;
        for (int k = 0; k < source.operandCount; ++k) instruction.operands[k] = current_[source.operands[k]];
        const Choice choice = isChoice(source.operation) ? choices[choiceNumber++] : Choice::open;
        const bool flips = source.operation == Operation::absolute && choice == Choice::second;
        if (flips) instruction.operation = Operation::negate;
        dropped_[i] = choice != Choice::open && !flips;
        current_[source.target] = dropped_[i] ? instruction.operands[chosenOperand(source.operation, choice)]
                                              : static_cast<Value>(i);
    }
}

void TapeShortener::markNeeded(Value result) {
    const auto end = static_cast<std::uint32_t>(instructions_.size());
    std::fill_n(lastUse_.begin(), end, unused);
    if (!isFixed(result)) lastUse_[result] = end;
    for (std::uint32_t i = end; i-- > 0;) {
        if (dropped_[i] || lastUse_[i] == unused) continue;
        for (int k = 0; k < resolved_[i].operandCount; ++k) {
            const Value operand = resolved_[i].operands[k];
            if (!isFixed(operand) && lastUse_[operand] == unused) lastUse_[operand] = i;
        }
    }
}

Slot TapeShortener::slotOf(Value value) const {
    return isFixed(value) ? value - static_cast<Value>(instructions_.size()) : slots_[value];
}

void TapeShortener::assignSlots(ShortTape& shortTape) {
    shortTape.instructions.clear();
    free_.clear();
    Slot next = tape_.firstReused();
    for (std::uint32_t i = 0; i < instructions_.size(); ++i) {
        if (dropped_[i] || lastUse_[i] == unused) continue;
        Instruction instruction = resolved_[i];
        const std::span<Slot> operands(instruction.operands.data(), instruction.operandCount);
        for (std::size_t k = 0; k < operands.size(); ++k) {
            const Value value = operands[k];
            operands[k] = slotOf(value);
            // The same value may be both operands: its slot is free once.
            if (!isFixed(value) && lastUse_[value] == i) {
                free_.push_back(operands[k]);
                lastUse_[value] = static_cast<std::uint32_t>(instructions_.size());
            }
        }
        if (free_.empty()) {
            slots_[i] = next++;
        } else {
            slots_[i] = free_.back();
            free_.pop_back();
        }
        instruction.target = slots_[i];
        shortTape.instructions.push_back(instruction);
    }
}

}  // namespace isoscope
