// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/taylor_evaluator.h"

#include <algorithm>

#include "core/evaluate/algebra/slope_operations.h"
#include "core/evaluate/prepared_function.h"
#include "core/evaluate/taylor_kernel.h"

namespace isoscope {

namespace {

constexpr std::size_t components = 7;

bool hasTangent(Operation operation) {
    return hasSlopeRule(operation) || operation == Operation::noise || isVectorNoise(operation);
}

}  // namespace

bool TaylorEvaluator::covers(const Tape& tape) {
    return !tape.isUniform(tape.results()[0]) &&
           std::ranges::all_of(tape.instructions(), [](const Instruction& instruction) {
               return hasTangent(instruction.operation);
           });
}

TaylorEvaluator::TaylorEvaluator(std::shared_ptr<const PreparedFunction> function)
    : workspace_(*function->tape(), function->uniforms(), components), programs_(std::move(function)) {
    for (int k = 0; k < workspace_.tape().argumentCount(); ++k) {
        double* argument = workspace_.ownArgument(k);
        std::fill_n(argument, components * batchLanes, 0.0);
        if (k < 3) std::fill_n(argument + static_cast<std::size_t>(k + 1) * batchLanes, batchLanes, 1.0);
    }
}

TaylorEvaluator::TaylorEvaluator(std::shared_ptr<const Tape> tape, std::span<const double> parameters)
    : TaylorEvaluator(PreparedFunction::of(std::move(tape), parameters)) {}

TaylorLanes TaylorEvaluator::evaluate(const RayPlaces& places, std::size_t count,
                                      const SimplifiedTape* simplifiedTape) {
    const Tape& tape = workspace_.tape();
    writeTangentArguments(places, count, workspace_);
    if (const StepProgram* program = programs_.find(workspace_, simplifiedTape, count))
        runTangentProgram(workspace_, *program, count);
    else
        runTangentInstructions(workspace_,
                               simplifiedTape != nullptr ? simplifiedTape->instructions : tape.instructions(),
                               count);
    evaluations_ += count;
    const double* lanes =
        workspace_.address(simplifiedTape != nullptr ? simplifiedTape->result : tape.results()[0]);
    const auto at = [lanes](std::size_t c) { return lanes + c * batchLanes; };
    return {{at(0), {at(1), at(2), at(3)}}, at(4), at(5), at(6)};
}

}  // namespace isoscope
