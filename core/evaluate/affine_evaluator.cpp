// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/affine_evaluator.h"

#include <algorithm>
#include <cmath>

#include "core/evaluate/affine_kernel.h"
#include "core/evaluate/interval_evaluator.h"
#include "core/evaluate/ray_piece_forms.h"

namespace isoscope {

namespace {

constexpr std::size_t components = 3;

bool hasCertainBounds(const Tape& tape) {
    for (const Instruction& instruction : tape.instructions())
        if (instruction.operation == Operation::crackle) return false;
    return std::all_of(tape.loops().begin(), tape.loops().end(),
                       [](const TapeLoop& loop) { return hasCertainBounds(*loop.body); });
}

}  // namespace

AffineEvaluator::AffineEvaluator(std::shared_ptr<const Tape> tape, std::span<const double> parameters)
    : tape_(std::move(tape)), workspace_(tape_, components), certain_(hasCertainBounds(*tape_)) {
    for (int k = 0; k < tape_->argumentCount(); ++k)
        std::fill_n(workspace_.ownArgument(k), components * batchLanes, 0.0);
    setParameters(parameters);
}

void AffineEvaluator::setParameters(std::span<const double> parameters) {
    workspace_.setParameters(parameters);
    // What operands can be wherever the ray is; arguments behind x, y, z are 0.
    IntervalEvaluator everywhere(tape_, parameters);
    const std::array box{Interval::all(), Interval::all(), Interval::all()};
    everywhere.evaluate(box);
    workspace_.limitDomains(everywhere);
}

void RayPieces::copyLane(std::size_t from, std::size_t to) {
    for (std::size_t k = 0; k < 3; ++k) {
        origin[k][to] = origin[k][from];
        direction[k][to] = direction[k][from];
    }
    start[to] = start[from];
    length[to] = length[from];
}

void AffineEvaluator::evaluate(const RayPieces& pieces, std::span<AffineForm> forms, std::size_t result) {
    const AffineLanes lanes = evaluate(pieces, forms.size(), result);
    for (std::size_t i = 0; i < forms.size(); ++i)
        forms[i] = {lanes.center[i], lanes.slope[i], lanes.error[i]};
}

AffineLanes AffineEvaluator::evaluate(const RayPieces& pieces, std::size_t count, std::size_t result,
                                      const RaySpread* spread) {
    placeArguments(pieces, count, spread);
    runAffineTape(workspace_, count);
    evaluations_ += count;
    const Slot slot = tape_->results()[result];
    if (workspace_.isUniform(slot)) {
        const double value = workspace_.uniform(slot);
        uniformForms_[0].fill(value);
        uniformForms_[1].fill(0);
        uniformForms_[2].fill(std::isnan(value)   ? -Interval::infinite
                              : std::isinf(value) ? Interval::infinite
                                                  : 0);
        return {uniformForms_[0].data(), uniformForms_[1].data(), uniformForms_[2].data()};
    }
    const double* lanes = workspace_.address(slot);
    return {lanes, lanes + batchLanes, lanes + 2 * batchLanes};
}

void AffineEvaluator::placeArguments(const RayPieces& pieces, std::size_t count, const RaySpread* spread) {
    const int arguments = std::min(3, tape_->argumentCount());
    for (int k = 0; k < arguments; ++k)
        writeRayPieceForms(pieces, spread, static_cast<std::size_t>(k), count,
                           workspace_.slot(static_cast<Slot>(k)));
}

}  // namespace isoscope
