// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/gradient_evaluator.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/evaluate/gradient_kernel.h"
#include "core/evaluate/prepared_function.h"

namespace isoscope {

namespace {

constexpr std::size_t components = 4;

/// Overflow in products of steep slopes is the last way to lose a finite derivative.
double finiteSlope(double slope) {
    if (std::isnan(slope)) return 0;
    return std::clamp(slope, -GradientEvaluator::steepest, GradientEvaluator::steepest);
}

}  // namespace

GradientEvaluator::GradientEvaluator(std::shared_ptr<const PreparedFunction> function)
    : workspace_(*function->tape(), function->uniforms(), components), programs_(std::move(function)) {
    for (int k = 0; k < workspace_.tape().argumentCount(); ++k) {
        double* argument = workspace_.ownArgument(k);
        std::fill_n(argument, components * batchLanes, 0.0);
        if (k < 3) std::fill_n(argument + static_cast<std::size_t>(k + 1) * batchLanes, batchLanes, 1.0);
    }
}

GradientEvaluator::GradientEvaluator(std::shared_ptr<const Tape> tape, std::span<const double> parameters)
    : GradientEvaluator(PreparedFunction::of(std::move(tape), parameters)) {}

void GradientEvaluator::evaluate(std::span<const double> x, std::span<const double> y,
                                 std::span<const double> z, std::span<ValueAndGradient> out,
                                 std::size_t result) {
    evaluate(x, y, z, out, nullptr, workspace_.tape().results()[result]);
}

void GradientEvaluator::evaluate(std::span<const double> x, std::span<const double> y,
                                 std::span<const double> z, std::span<ValueAndGradient> out,
                                 const SimplifiedTape& simplifiedTape) {
    evaluate(x, y, z, out, &simplifiedTape, simplifiedTape.result);
}

void GradientEvaluator::evaluate(std::span<const double> x, std::span<const double> y,
                                 std::span<const double> z, std::span<ValueAndGradient> out,
                                 const SimplifiedTape* simplifiedTape, Slot result) {
    for (std::size_t first = 0; first < out.size(); first += batchLanes) {
        const std::size_t lanes = std::min(batchLanes, out.size() - first);
        run({x.data() + first, y.data() + first, z.data() + first}, lanes, simplifiedTape);
        writeResult(result, out.subspan(first, lanes));
    }
}

ValueAndGradient GradientEvaluator::evaluate(double x, double y, double z) {
    ValueAndGradient value;
    run({&x, &y, &z}, 1, nullptr);
    writeResult(workspace_.tape().results()[0], {&value, 1});
    return value;
}

GradientLanes GradientEvaluator::evaluateLanes(const std::array<const double*, 3>& point, std::size_t count) {
    run(point, count, nullptr);
    return lanesOf(workspace_.tape().results()[0]);
}

GradientLanes GradientEvaluator::evaluateLanes(const std::array<const double*, 3>& point, std::size_t count,
                                               const SimplifiedTape& simplifiedTape) {
    run(point, count, &simplifiedTape);
    return lanesOf(simplifiedTape.result);
}

GradientLanes GradientEvaluator::lanesOf(Slot slot) {
    if (workspace_.isUniform(slot)) {
        uniform_[0].fill(workspace_.uniform(slot));
        const double* none = uniform_[1].data();
        return {uniform_[0].data(), {none, none, none}};
    }
    const double* lanes = workspace_.address(slot);
    return {lanes, {lanes + batchLanes, lanes + 2 * batchLanes, lanes + 3 * batchLanes}};
}

std::array<double*, 3> GradientEvaluator::pointLanes() {
    std::array<double*, 3> lanes{};
    for (int k = 0; k < std::min(3, workspace_.tape().argumentCount()); ++k)
        lanes[static_cast<std::size_t>(k)] = workspace_.slot(static_cast<Slot>(k));
    return lanes;
}

void GradientEvaluator::run(const std::array<const double*, 3>& point, std::size_t lanes,
                            const SimplifiedTape* simplifiedTape) {
    const auto count = static_cast<std::size_t>(std::min(3, workspace_.tape().argumentCount()));
    for (std::size_t k = 0; k < count; ++k) {
        double* argument = workspace_.slot(static_cast<Slot>(k));
        if (point[k] != argument) std::copy_n(point[k], lanes, argument);
        std::fill(argument + lanes, argument + batchLanes, argument[lanes - 1]);
    }
    if (const StepProgram* program = programs_.find(workspace_, simplifiedTape, lanes))
        return runGradientProgram(workspace_, *program, lanes);
    runGradientInstructions(
        workspace_,
        simplifiedTape != nullptr ? simplifiedTape->instructions : workspace_.tape().instructions(), lanes);
}

void GradientEvaluator::writeResult(Slot slot, std::span<ValueAndGradient> out) const {
    if (workspace_.isUniform(slot)) {
        std::fill(out.begin(), out.end(), ValueAndGradient{workspace_.uniform(slot), {}});
        return;
    }
    const double* lanes = workspace_.address(slot);
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = {lanes[i],
                  {finiteSlope(lanes[batchLanes + i]), finiteSlope(lanes[2 * batchLanes + i]),
                   finiteSlope(lanes[3 * batchLanes + i])}};
}

double slopeOf(const ValueAndGradient& at) {
    if (std::isnan(at.value)) return std::numeric_limits<double>::quiet_NaN();
    const double length = std::hypot(at.gradient[0], at.gradient[1], at.gradient[2]);
    return length >= GradientEvaluator::steepest ? std::numeric_limits<double>::infinity() : length;
}

}  // namespace isoscope
