// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/slope_evaluator.h"

#include <algorithm>

#include "core/evaluate/algebra/slope_operations.h"
#include "core/evaluate/prepared_function.h"
#include "core/evaluate/slope_kernel.h"

namespace isoscope {

namespace {

constexpr std::size_t components = 6;

}  // namespace

bool SlopeEvaluator::covers(const Tape& tape) {
    const auto instructions = tape.instructions();
    return !tape.isUniform(tape.results()[0]) &&
           std::all_of(instructions.begin(), instructions.end(),
                       [](const Instruction& instruction) { return hasSlopeRule(instruction.operation); });
}

SlopeEvaluator::SlopeEvaluator(std::shared_ptr<const PreparedFunction> function)
    : function_(std::move(function)),
      global_(function_->global()),
      workspace_(*function_->tape(), function_->uniforms(), components, &global_->domains()) {}

SlopeEvaluator::SlopeEvaluator(std::shared_ptr<const Tape> tape, std::span<const double> parameters)
    : SlopeEvaluator(PreparedFunction::of(std::move(tape), parameters)) {}

SlopeLanes SlopeEvaluator::evaluate(const RayPieces& pieces, const RaySpread& spread, std::size_t count) {
    writeSlopeArguments(pieces, spread, count, workspace_);
    runSlopeTape(workspace_, count);
    evaluations_ += count;
    const double* lanes = workspace_.address(workspace_.tape().results()[0]);
    const auto at = [lanes](std::size_t c) { return lanes + c * batchLanes; };
    return {{at(0), at(1), at(2)}, at(3), at(4), at(5)};
}

}  // namespace isoscope
