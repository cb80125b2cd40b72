// SPDX-License-Identifier: GPL-3.0-or-later
// The part of IntervalGradientEvaluator that leaves out what does not matter in a box.
#include <algorithm>

#include "core/evaluate/interval_gradient_evaluator.h"
#include "core/evaluate/tape/simplified_tape.h"

namespace isoscope {

using gradient_rules::ChosenSide;

namespace {

using Excerpt = IntervalGradientEvaluator::Excerpt;

/// The operand whose value a decided choice has. That of a magnitude may have the other sign.
std::size_t takenOperand(const Instruction& instruction, ChosenSide side) {
    if (instruction.operation == Operation::absolute) return 0;
    const bool second = side == ChosenSide::second;
    if (isSelect(instruction.operation)) return second ? instruction.operandCount - 1u : 1;
    return second ? 1 : 0;
}

bool changesSign(const Instruction& instruction, ChosenSide side) {
    return instruction.operation == Operation::absolute && side == ChosenSide::second;
}

}  // namespace

/// All instructions, each with the entries that its operands come from.
Excerpt IntervalGradientEvaluator::everything() const {
    const auto& instructions = tape_->instructions();
    Excerpt all;
    std::vector<std::uint32_t> sources(tape_->slotCount());
    for (std::size_t slot = 0; slot < sources.size(); ++slot)
        sources[slot] = Excerpt::fixed | static_cast<std::uint32_t>(slot);
    for (std::size_t i = 0; i < instructions.size(); ++i) {
        Excerpt::Entry& entry = all.entries.emplace_back();
        entry.instruction = static_cast<std::uint32_t>(i);
        const WholePower& power = powers_[i];
        entry.operandCount = power.exponent > 0 ? 1 : static_cast<std::uint8_t>(instructions[i].operandCount);
        for (std::size_t k = 0; k < entry.operandCount; ++k)
            entry.operands[k] = sources[instructions[i].operands[k]];
        if (power.exponent > 0)
            entry.operands[0] = static_cast<std::uint32_t>(
                power.base < slots_.size() ? Excerpt::fixed | power.base : power.base - slots_.size());
        sources[instructions[i].target] = static_cast<std::uint32_t>(i);
    }
    all.result = sources[tape_->results()[0]];
    return all;
}

std::shared_ptr<const Excerpt> IntervalGradientEvaluator::excerpt(
    const std::shared_ptr<const Excerpt>& within) const {
    const auto isDecided = [&](std::size_t instruction) { return chosen_[instruction] != ChosenSide::open; };
    // What becomes of values in loops is not looked into.
    if (!loops_.empty()) return {};
    const auto& instructions = tape_->instructions();
    const bool any =
        within
            ? std::ranges::any_of(within->entries,
                                  [&](const Excerpt::Entry& entry) {
                                      return entry.side == ChosenSide::open && isDecided(entry.instruction);
                                  })
            : std::ranges::any_of(chosen_, [](ChosenSide side) { return side != ChosenSide::open; });
    if (!any) return within;
    Excerpt own = within ? shorten(*within) : shorten(everything());
    const std::size_t before = within ? within->entries.size() : instructions.size();
    constexpr std::size_t worthwhilePart = 8;
    if (own.entries.size() >= before - before / worthwhilePart) return within;
    return std::make_shared<const Excerpt>(std::move(own));
}

Excerpt IntervalGradientEvaluator::shorten(const Excerpt& within) const {
    const auto& entries = within.entries;
    // Decided choices are what they take.
    std::vector<std::uint32_t> sources(entries.size());
    std::vector<ChosenSide> sides(entries.size());
    const auto sourceOf = [&](std::uint32_t value) {
        return value < Excerpt::fixed ? sources[value] : value;
    };
    for (std::uint32_t i = 0; i < entries.size(); ++i) {
        const Instruction& instruction = tape_->instructions()[entries[i].instruction];
        sides[i] = chosen_[entries[i].instruction];
        const bool isTaken = sides[i] != ChosenSide::open && !changesSign(instruction, sides[i]);
        sources[i] = isTaken ? sourceOf(entries[i].operands[takenOperand(instruction, sides[i])]) : i;
    }
    std::vector<std::uint8_t> needed(entries.size());
    const auto need = [&](std::uint32_t value) {
        if (value < Excerpt::fixed) needed[value] = 1;
    };
    need(sourceOf(within.result));
    for (std::size_t i = entries.size(); i-- > 0;)
        for (std::size_t k = 0; needed[i] != 0 && k < entries[i].operandCount; ++k)
            need(sourceOf(entries[i].operands[k]));
    Excerpt result;
    std::vector<std::uint32_t> numbers(entries.size());
    const auto numberOf = [&](std::uint32_t value) {
        const std::uint32_t source = sourceOf(value);
        return source < Excerpt::fixed ? numbers[source] : source;
    };
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (needed[i] == 0) continue;
        numbers[i] = static_cast<std::uint32_t>(result.entries.size());
        Excerpt::Entry& entry = result.entries.emplace_back(entries[i]);
        entry.side = sides[i];
        for (std::size_t k = 0; k < entry.operandCount; ++k) entry.operands[k] = numberOf(entry.operands[k]);
    }
    result.result = numberOf(within.result);
    return result;
}

const IntervalGradient& IntervalGradientEvaluator::evaluate(std::span<const Interval, 3> box,
                                                            const std::shared_ptr<const Excerpt>& excerpt) {
    if (!excerpt) return evaluate(box);
    begin(box);
    if (short_.size() < excerpt->entries.size()) short_.resize(excerpt->entries.size());
    const auto valueOf = [&](std::uint32_t value) -> IntervalGradient& {
        return value < Excerpt::fixed ? short_[value] : slots_[value & ~Excerpt::fixed];
    };
    bool ended = true;
    for (std::size_t i = 0; i < excerpt->entries.size(); ++i) {
        if (stopsNow()) {
            ended = false;
            break;
        }
        const Excerpt::Entry& entry = excerpt->entries[i];
        const Instruction& instruction = tape_->instructions()[entry.instruction];
        std::array<const IntervalGradient*, 4> operands{};
        for (std::size_t k = 0; k < entry.operandCount; ++k) operands[k] = &valueOf(entry.operands[k]);
        const auto all = std::span(operands).first(entry.operandCount);
        const auto value = [&] {
            if (entry.side == ChosenSide::open)
                return apply(instruction, entry.instruction, all, operands[0]);
            chosen_[entry.instruction] = entry.side;
            return gradient_rules::takenSide(instruction.operation, all, true);
        };
        // Copies would take as long as many an operation.
        auto* made = ::new (static_cast<void*>(&short_[i])) IntervalGradient(value());
        made->root.known = made->root.known && wantedRoots_[entry.instruction];
    }
    return finish(valueOf(excerpt->result), ended);
}

}  // namespace isoscope
