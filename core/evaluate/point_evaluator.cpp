// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/point_evaluator.h"

#include <algorithm>
#include <array>

#include "core/evaluate/point_kernel.h"
#include "core/evaluate/prepared_function.h"

namespace isoscope {

PointEvaluator::PointEvaluator(std::shared_ptr<const PreparedFunction> function)
    : tape_(function->tape().get()),
      workspace_(*tape_, function->uniforms(), 1),
      programs_(std::move(function)) {}

PointEvaluator::PointEvaluator(std::shared_ptr<const Tape> tape, std::span<const double> parameters)
    : PointEvaluator(PreparedFunction::of(std::move(tape), parameters)) {}

void PointEvaluator::evaluate(std::span<const double> x, std::span<const double> y, std::span<const double> z,
                              std::span<double> out, std::size_t result) {
    const std::array<const double*, 3> arguments{x.data(), y.data(), z.data()};
    evaluate(arguments, out.size(), out, result);
}

void PointEvaluator::evaluate(std::span<const double* const> arguments, std::size_t count,
                              std::span<double> out, std::size_t result) {
    for (std::size_t first = 0; first < count; first += batchLanes)
        run(arguments, first, result, out.subspan(first, std::min(batchLanes, count - first)));
    evaluations_ += count;
}

void PointEvaluator::evaluateAll(std::span<const double* const> arguments, std::size_t count,
                                 std::span<double* const> out) {
    for (std::size_t first = 0; first < count; first += batchLanes) {
        const std::size_t lanes = std::min(batchLanes, count - first);
        run(arguments, first, 0, {out[0] + first, lanes});
        // The run may have written the first result to its place alone.
        const auto isFirst = [&](std::size_t result) {
            return tape_->results()[result] == tape_->results()[0];
        };
        for (std::size_t result = 1; result < out.size(); ++result)
            if (isFirst(result))
                std::copy_n(out[0] + first, lanes, out[result] + first);
            else
                writeResult(result, {out[result] + first, lanes});
    }
    evaluations_ += count;
}

void PointEvaluator::evaluate(std::span<const double> x, std::span<const double> y, std::span<const double> z,
                              std::span<double> out, const SimplifiedTape& simplifiedTape) {
    const std::array<const double*, 3> arguments{x.data(), y.data(), z.data()};
    for (std::size_t first = 0; first < out.size(); first += batchLanes) {
        const std::size_t lanes = std::min(batchLanes, out.size() - first);
        placeArguments(arguments, first, lanes);
        runPointInstructions(workspace_, simplifiedTape.instructions, lanes);
        writeSlot(simplifiedTape.result, out.subspan(first, lanes));
    }
    evaluations_ += out.size();
}

double PointEvaluator::evaluate(double x, double y, double z) {
    const std::array<const double*, 3> arguments{&x, &y, &z};
    double value = 0;
    run(arguments, 0, 0, {&value, 1});
    ++evaluations_;
    return value;
}

void PointEvaluator::placeArguments(std::span<const double* const> arguments, std::size_t first,
                                    std::size_t lanes) {
    for (int index = 0; index < tape_->argumentCount(); ++index) {
        const auto k = static_cast<std::size_t>(index);
        const bool given = k < arguments.size();
        if (given && lanes == batchLanes) {
            workspace_.pointTo(index, arguments[k] + first);
            continue;
        }
        // The vectors at the end are filled up with the last point, which costs no slow path of its own.
        double* own = workspace_.ownArgument(index);
        if (given) std::copy_n(arguments[k] + first, lanes, own);
        std::fill(own + (given ? lanes : 0), own + batchLanes, given ? own[lanes - 1] : 0.0);
    }
}

void PointEvaluator::run(std::span<const double* const> arguments, std::size_t first, std::size_t result,
                         std::span<double> out) {
    const std::size_t lanes = out.size();
    placeArguments(arguments, first, lanes);
    StepProgram* program = programs_.find(workspace_, nullptr, lanes);
    if (program == nullptr) {
        runPointTape(workspace_, lanes);
        return writeResult(result, out);
    }
    program->bind(workspace_);
    const bool written = program->writeTo(tape_->results()[result], out.data());
    runPointProgram(workspace_, *program);
    if (!written) writeResult(result, out);
}

void PointEvaluator::writeResult(std::size_t result, std::span<double> out) const {
    writeSlot(tape_->results()[result], out);
}

void PointEvaluator::writeSlot(Slot slot, std::span<double> out) const {
    if (workspace_.isUniform(slot))
        std::fill(out.begin(), out.end(), workspace_.uniform(slot));
    else
        std::copy_n(workspace_.address(slot), out.size(), out.begin());
}

}  // namespace isoscope
