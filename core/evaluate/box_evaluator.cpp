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
      workspace_(*tape_, function_->uniforms(), components) {
    for (int k = 0; k < tape_->argumentCount(); ++k)
        std::fill_n(workspace_.ownArgument(k), components * batchLanes, 0.0);
}

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
    runIntervalInstructions(workspace_, instructions, out.size());
    evaluations_ += out.size();
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
    const int arguments = std::min(3, tape_->argumentCount());
    for (int k = 0; k < arguments; ++k) {
        double* lanes = workspace_.slot(static_cast<Slot>(k));
        for (std::size_t i = 0; i < batchLanes; ++i) {
            // The lanes that fill up the last vector do what the last box does.
            const std::size_t box = std::min(i, count - 1);
            const double low = boxes.low[k][box], high = boxes.high[k][box];
            lanes[i] = std::isnan(high) ? Interval::infinite : high;
            lanes[batchLanes + i] = std::isnan(low) ? Interval::infinite : -low;
        }
    }
}

}  // namespace isoscope
