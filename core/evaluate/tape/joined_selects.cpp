// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/tape/joined_selects.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/evaluate/interval_evaluator.h"
#include "core/evaluate/tape/tape_sources.h"

namespace isoscope {

namespace {

/// Looking at each select takes the square of this.
constexpr std::size_t mostInstructions = 1000;

/// What is known of a slot at the places where a condition is 0: its value, or which source has the same.
struct Known {
    std::optional<Interval> number;
    TapeSource source = 0;

    /// Whether it is `value`, but for roundings.
    bool isAbout(double value) const {
        constexpr double rounding = 1e-13;
        return number && number->low <= value && value <= number->high && number->width() < rounding;
    }
};

bool areSame(const Known& a, const Known& b) {
    if (!a.number || !b.number) return !a.number && !b.number && a.source == b.source;
    constexpr double rounding = 1e-12;
    const Interval both = hull(*a.number, *b.number);
    const bool meet = a.number->low <= b.number->high && b.number->low <= a.number->high;
    return meet && both.isDefined() &&
           both.width() <= rounding * (1 + std::abs(both.low) + std::abs(both.high));
}

bool isSelect(Operation operation) {
    return operation == Operation::select3 || operation == Operation::select4;
}

/// The operand, if any, that the result is equal to.
std::optional<std::size_t> sameAs(Operation operation, std::span<const Known> operands) {
    switch (operation) {
        case Operation::add:
            if (operands[0].isAbout(0)) return 1;
            [[fallthrough]];
        case Operation::subtract:
            if (operands[1].isAbout(0)) return 0;
            return {};
        case Operation::multiply:
            // Also 0 times anything.
            if (operands[0].isAbout(1) || operands[1].isAbout(0)) return 1;
            if (operands[1].isAbout(1) || operands[0].isAbout(0)) return 0;
            return {};
        case Operation::divide:
            if (operands[1].isAbout(1)) return 0;
            return {};
        case Operation::select3:
        case Operation::select4: {
            const auto& condition = operands[0].number;
            if (!condition || condition->maybeUndefined) return {};
            if (condition->high < 0) return 1;
            if (condition->low > 0 || (condition->low == 0 && operands.size() == 3))
                return operands.size() - 1;
            if (condition->low == 0 && condition->high == 0) return 2;
            return {};
        }
        default: return {};
    }
}

Known resultOf(TapeSource source, const Instruction& instruction, std::span<const Known> operands) {
    if (const auto same = sameAs(instruction.operation, operands)) return operands[*same];
    const bool ownSettings = instruction.operation == Operation::crackle ||
                             instruction.operation == Operation::sum ||
                             instruction.operation == Operation::product;
    std::array<Interval, 4> values{};
    for (std::size_t k = 0; k < operands.size(); ++k) {
        if (!operands[k].number || ownSettings) return {{}, source};
        values[k] = *operands[k].number;
    }
    return {evaluateOperation(instruction.operation, std::span(values).first(operands.size())), source};
}

class JoinedSelects {
  public:
    JoinedSelects(const Tape& tape, std::span<const double> uniforms)
        : tape_(tape), start_(tape.slotCount()), sources_(operandSources(tape)) {
        for (std::size_t k = 0; k < start_.size(); ++k) start_[k].source = k;
        for (std::size_t k = 0; k < uniforms.size(); ++k)
            start_[tape.firstUniform() + k].number = Interval::point(uniforms[k]);
    }

    bool isJoined(std::size_t select) const {
        if (!isSelect(tape_.instructions()[select].operation)) return false;
        const auto [zero, value] = zeroOf(sources_[select][0]);
        if (!std::isfinite(value)) return false;
        std::vector<Known> slots = start_;
        const auto setZero = [&, zero = zero, value = value](TapeSource source, Known& known) {
            if (source == zero) known = {Interval::point(value), source};
        };
        for (std::size_t k = 0; k < slots.size(); ++k) setZero(k, slots[k]);
        std::array<Known, 4> operands;
        for (std::size_t i = 0; i <= select; ++i) {
            const Instruction& instruction = tape_.instructions()[i];
            for (std::size_t k = 0; k < instruction.operandCount; ++k)
                operands[k] = slots[instruction.operands[k]];
            if (i == select) break;
            const TapeSource source = tape_.slotCount() + i;
            slots[instruction.target] =
                resultOf(source, instruction, std::span(operands).first(instruction.operandCount));
            setZero(source, slots[instruction.target]);
        }
        const std::size_t last = tape_.instructions()[select].operandCount - 1;
        for (std::size_t k = 2; k <= last; ++k)
            if (!areSame(operands[1], operands[k])) return false;
        return true;
    }

  private:
    /// What has which value where a condition is 0, and nowhere else; NaN where that is not known.
    std::pair<TapeSource, double> zeroOf(TapeSource condition) const {
        const auto uniform = [&](TapeSource source) {
            return source < tape_.slotCount() && tape_.isUniform(static_cast<Slot>(source));
        };
        if (condition < tape_.slotCount()) return {condition, uniform(condition) ? std::nan("") : 0};
        const std::size_t i = condition - tape_.slotCount();
        const Operation operation = tape_.instructions()[i].operation;
        if (operation == Operation::add || operation == Operation::subtract) {
            const double sign = operation == Operation::add ? -1 : 1;
            const auto [a, b] = std::pair(sources_[i][0], sources_[i][1]);
            if (uniform(b)) return {a, sign * start_[b].number->low};
            if (uniform(a)) return {b, sign * start_[a].number->low};
        }
        return {condition, 0};
    }

    const Tape& tape_;
    std::vector<Known> start_;  ///< by slot, before the first instruction
    std::vector<std::array<TapeSource, 4>> sources_;
};

}  // namespace

std::vector<bool> joinedSelects(const Tape& tape, std::span<const double> uniforms) {
    const std::size_t count = tape.instructions().size();
    std::vector<bool> joined(count, false);
    if (count > mostInstructions) return joined;
    const JoinedSelects selects(tape, uniforms);
    for (std::size_t i = 0; i < count; ++i) joined[i] = selects.isJoined(i);
    return joined;
}

}  // namespace isoscope
