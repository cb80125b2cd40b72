// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/tape/operand_domains.h"

#include <algorithm>
#include <cstdint>
#include <span>

#include "core/evaluate/interval_evaluator.h"
#include "core/evaluate/tape/tape.h"

namespace isoscope {

namespace {

/// What is known of values from what they are made of, not from the ranges of their operands.
class KnownRatios {
  public:
    explicit KnownRatios(const Tape& tape) : instructions_(tape.instructions()) {
        const auto isQuotient = [](const Instruction& instruction) {
            return instruction.operation == Operation::divide;
        };
        if (std::ranges::none_of(instructions_, isQuotient)) return;
        operands_.reserve(instructions_.size());
        std::vector<std::uint32_t> writers(tape.slotCount(), nowhere);
        for (std::uint32_t i = 0; i < instructions_.size(); ++i) {
            Value* operands = operands_.emplace_back().data();
            for (std::size_t k = 0; k < std::min<std::size_t>(instructions_[i].operandCount, 2); ++k)
                operands[k] = {instructions_[i].operands[k], writers[instructions_[i].operands[k]]};
            writers[instructions_[i].target] = i;
        }
    }

    /// Whether operand k of the instruction is a coordinate by a length: y / sqrt(x^2 + y^2).
    bool isSine(std::size_t instruction, std::size_t k) const {
        if (operands_.empty()) return false;
        const std::uint32_t quotient = operands_[instruction][k].writer;
        if (!is(quotient, Operation::divide)) return false;
        const std::uint32_t root = operands_[quotient][1].writer;
        if (!is(root, Operation::squareRoot)) return false;
        Sum sum{operands_[quotient][0]};
        return sum.add(*this, operands_[root][0].writer) && sum.holdsTerm;
    }

  private:
    static constexpr std::uint32_t nowhere = 0xffffffff;

    /// A value, by its slot and the instruction that wrote it last.
    struct Value {
        Slot slot = 0;
        std::uint32_t writer = nowhere;
        bool operator==(const Value&) const = default;
    };

    bool is(std::uint32_t writer, Operation operation) const {
        return writer != nowhere && instructions_[writer].operation == operation;
    }
    /// A sum of squares, as far as it is known.
    struct Sum {
        Value term;  ///< what one of the squares should be of
        bool holdsTerm = false;
        int partsLeft = 16;  ///< a part may be there many times over

        bool add(const KnownRatios& ratios, std::uint32_t writer) {
            if (--partsLeft < 0) return false;
            if (ratios.is(writer, Operation::square)) {
                holdsTerm = holdsTerm || ratios.operands_[writer][0] == term;
                return true;
            }
            return ratios.is(writer, Operation::add) && add(ratios, ratios.operands_[writer][0].writer) &&
                   add(ratios, ratios.operands_[writer][1].writer);
        }
    };

    std::span<const Instruction> instructions_;
    std::vector<std::array<Value, 2>> operands_;
};

}  // namespace

OperandDomains::OperandDomains(const Tape& tape, const IntervalEvaluator& everywhere)
    : limits(tape.instructions().size(),
             {-Interval::infinite, Interval::infinite, -Interval::infinite, Interval::infinite}) {
    const std::span<const Instruction> instructions = tape.instructions();
    const KnownRatios ratios(tape);
    for (std::size_t number = 0; number < instructions.size(); ++number)
        for (std::size_t k = 0; k < std::min<std::size_t>(instructions[number].operandCount, 2); ++k) {
            const Interval& range = everywhere.operandRange(number, static_cast<int>(k));
            // An operand that never has a value needs no limits.
            if (range.empty()) continue;
            const bool isSine = ratios.isSine(number, k);
            limits[number][2 * k] = isSine ? std::max(range.low, -1.0) : range.low;
            limits[number][2 * k + 1] = isSine ? std::min(range.high, 1.0) : range.high;
        }
    for (std::uint32_t k = 0; k < tape.loops().size(); ++k)
        loops.emplace_back(*tape.loop(k).body, everywhere.loop(k));
}

}  // namespace isoscope
