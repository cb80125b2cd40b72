// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/box_evaluator.h"

#include <algorithm>
#include <cmath>

#include "core/evaluate/interval_kernel.h"
#include "core/evaluate/prepared_function.h"

namespace isoscope {

namespace {

constexpr std::size_t components = 3;

Choice choiceOf(std::uint8_t sides) {
    return sides == 3 ? Choice::open : sides == 2 ? Choice::second : Choice::first;
}

}  // namespace

BoxEvaluator::BoxEvaluator(std::shared_ptr<const PreparedFunction> function)
    : function_(std::move(function)),
      tape_(function_->tape().get()),
      workspace_(*tape_, function_->uniforms(), components) {}

BoxEvaluator::BoxEvaluator(std::shared_ptr<const Tape> tape, std::span<const double> parameters)
    : BoxEvaluator(PreparedFunction::of(std::move(tape), parameters)) {}

void BoxEvaluator::evaluate(const BoxLanes& boxes, std::span<Interval> out, std::size_t result) {
    workspace_.forgetChoices();
    run(boxes, tape_->instructions(), tape_->results()[result], out);
    choices_.clear();
    for (const Instruction& instruction : tape_->instructions())
        if (isChoice(instruction.operation))
            choices_.push_back(choiceOf(*workspace_.choiceSides(instruction.number)));
}

void BoxEvaluator::evaluate(const BoxLanes& boxes, const SimplifiedTape& tape, std::span<Interval> out) {
    run(boxes, tape.instructions, tape.result, out);
}

void BoxEvaluator::run(const BoxLanes& boxes, std::span<const Instruction> instructions, Slot result,
                       std::span<Interval> out) {
    placeArguments(boxes, out.size());
    {
        const UpwardRounding upward;
        runIntervalInstructions(workspace_, instructions, out.size());
    }
    evaluations_ += out.size();
    read(result, out);
}

void BoxEvaluator::evaluateChoices(const BoxLanes& boxes, const SimplifiedTape& tape, const SignStakes& signs,
                                   std::span<Interval> out, std::vector<LaneChoices>& choices) {
    placeArguments(boxes, out.size());
    choices.clear();
    {
        const UpwardRounding upward;
        const std::span<const Instruction> instructions(tape.instructions);
        std::size_t begun = 0;
        for (std::size_t i = 0; i < instructions.size(); ++i) {
            if (!isChoice(instructions[i].operation)) continue;
            // The operands are in their slots only until later instructions use them anew.
            runIntervalInstructions(workspace_, instructions.subspan(begun, i - begun), out.size());
            begun = i;
            choices.push_back(decide(instructions[i], out.size(), signs.of(choices.size())));
        }
        runIntervalInstructions(workspace_, instructions.subspan(begun), out.size());
    }
    evaluations_ += out.size();
    read(tape.result, out);
}

/// As decideAffineChoices() does it for forms; what is empty or not defined everywhere decides nothing.
LaneChoices BoxEvaluator::decide(const Instruction& instruction, std::size_t count,
                                 const SignLevel* level) const {
    const bool twoSided =
        instruction.operation == Operation::minimum || instruction.operation == Operation::maximum;
    const bool takesLower =
        instruction.operation != Operation::maximum && instruction.operation != Operation::absolute;
    const bool takesLast =
        isSelect(instruction.operation) && cheapestCase(*tape_, instruction) == Choice::second;
    struct Range {
        double low, high;
        bool sure;
        /// By more than values as doubles are off.
        bool below(const Range& other) const {
            constexpr double roundings = 1e-15;
            return high + roundings * (std::abs(high) + std::abs(other.low)) < other.low;
        }
    };
    const Range number =
        level == nullptr ? Range{} : Range{level->value - level->reach, level->value + level->reach, true};
    const auto operand = [&](std::size_t k, std::size_t lane) -> Range {
        const Slot slot = instruction.operands[k];
        if (workspace_.isUniform(slot)) {
            const double value = workspace_.uniform(slot);
            return {value, value, !std::isnan(value)};
        }
        const double* lanes = workspace_.address(slot) + lane;
        const double low = -lanes[batchLanes], high = lanes[0];
        return {low, high, lanes[2 * batchLanes] == 0 && low <= high};
    };
    LaneChoices choices;
    for (std::size_t lane = 0; lane < count; ++lane) {
        if (level != nullptr && isSelect(instruction.operation)) {
            const auto allBeyond = [&](bool above) {
                for (std::size_t k = 1; k < instruction.operandCount; ++k) {
                    const Range side = operand(k, lane);
                    if (!side.sure || !(above ? number.below(side) : side.below(number))) return false;
                }
                return true;
            };
            // Whichever is taken, the sign is the same.
            if (allBeyond(true) || allBeyond(false)) {
                (takesLast ? choices.second : choices.first) |= std::uint64_t(1) << lane;
                continue;
            }
        }
        const Range p = operand(0, lane);
        // abs and select compare with 0.
        const Range q = twoSided ? operand(1, lane) : Range{0, 0, true};
        if (!p.sure || !q.sure) continue;
        bool first = takesLower ? p.below(q) : q.below(p);
        bool second = takesLower ? q.below(p) : p.below(q);
        if (level != nullptr && twoSided && !first && !second) {
            // What is above the level is above it, whichever operand of min is left to say so.
            second = takesLower ? number.below(p) : p.below(number);
            first = !second && (takesLower ? number.below(q) : q.below(number));
        }
        choices.first |= std::uint64_t(first) << lane;
        choices.second |= std::uint64_t(second) << lane;
    }
    return choices;
}

void BoxEvaluator::read(Slot result, std::span<Interval> out) const {
    if (workspace_.isUniform(result)) {
        const double value = workspace_.uniform(result);
        std::fill(out.begin(), out.end(), std::isinf(value) ? Interval::unknown() : Interval::point(value));
        return;
    }
    const double* lanes = workspace_.address(result);
    for (std::size_t i = 0; i < out.size(); ++i) {
        const bool doubtful = lanes[2 * batchLanes + i] != 0;
        out[i] = {-lanes[batchLanes + i], lanes[i], doubtful};
    }
}

void BoxEvaluator::placeArguments(const BoxLanes& boxes, std::size_t count) {
    const auto arguments = static_cast<std::size_t>(std::min(3, tape_->argumentCount()));
    // Vectors have no more than 8 lanes.
    const std::size_t end = std::min(batchLanes, (count + 7) / 8 * 8);
    for (std::size_t k = 0; k < arguments; ++k) {
        double* lanes = workspace_.slot(static_cast<Slot>(k));
        for (std::size_t i = 0; i < end; ++i) {
            // The lanes that fill up the last vector do what the last box does.
            const std::size_t box = std::min(i, count - 1);
            const double low = boxes.low[k][box], high = boxes.high[k][box];
            lanes[i] = std::isnan(high) ? Interval::infinite : high;
            lanes[batchLanes + i] = std::isnan(low) ? Interval::infinite : -low;
        }
    }
}

}  // namespace isoscope
