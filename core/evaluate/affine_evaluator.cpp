// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/affine_evaluator.h"

#include <algorithm>
#include <cmath>

#include "core/evaluate/affine_kernel.h"
#include "core/evaluate/interval_evaluator.h"

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

void AffineEvaluator::evaluate(const RayPieces& pieces, std::span<AffineForm> forms, std::size_t result) {
    placeArguments(pieces);
    runAffineTape(workspace_, forms.size());
    evaluations_ += forms.size();
    const Slot slot = tape_->results()[result];
    if (workspace_.isUniform(slot)) {
        const double value = workspace_.uniform(slot);
        const double error = std::isnan(value)   ? -Interval::infinite
                             : std::isinf(value) ? Interval::infinite
                                                 : 0;
        std::fill(forms.begin(), forms.end(), AffineForm{value, 0, error});
        return;
    }
    const double* lanes = workspace_.address(slot);
    for (std::size_t i = 0; i < forms.size(); ++i)
        forms[i] = {lanes[i], lanes[batchLanes + i], lanes[2 * batchLanes + i]};
}

void AffineEvaluator::placeArguments(const RayPieces& pieces) {
    const int count = std::min(3, tape_->argumentCount());
    for (int k = 0; k < count; ++k) {
        double* form = workspace_.slot(static_cast<Slot>(k));
        const auto& origin = pieces.origin[k];
        const auto& direction = pieces.direction[k];
        for (std::size_t i = 0; i < batchLanes; ++i) {
            const double half = 0.5 * pieces.length[i];
            const double along = (pieces.start[i] + half) * direction[i];
            const double center = origin[i] + along, slope = half * direction[i];
            form[i] = center;
            form[batchLanes + i] = slope;
            // Four roundings: of the middle, two of the centre, one of the slope.
            form[2 * batchLanes + i] = 2.5e-16 * (std::abs(center) + std::abs(along) + std::abs(slope)) +
                                       std::numeric_limits<double>::min();
        }
    }
}

}  // namespace isoscope
