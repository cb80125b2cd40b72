// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/tape/tape_workspace.h"

#include <algorithm>

#include "core/evaluate/interval_evaluator.h"
#include "core/evaluate/tape/loop_range.h"

namespace isoscope {

namespace {

hwy::AlignedFreeUniquePtr<double[]> zeros(std::size_t count) {
    auto memory = hwy::AllocateAligned<double>(std::max<std::size_t>(count, 1));
    std::fill_n(memory.get(), count, 0.0);
    return memory;
}

}  // namespace

TapeWorkspace::TapeWorkspace(std::shared_ptr<const Tape> tape, std::size_t components)
    : tape_(std::move(tape)),
      components_(components),
      stride_(components * batchLanes),
      firstUniform_(tape_->firstUniform()),
      skipped_(tape_->uniformCount()),
      memory_(zeros((tape_->slotCount() - skipped_) * stride_)),
      spread_(zeros(4 * stride_)),
      addresses_(tape_->slotCount()),
      uniforms_(tape_->uniformCount()),
      domains_(tape_->instructions().size(),
               {-Interval::infinite, Interval::infinite, -Interval::infinite, Interval::infinite}),
      choiceSides_(tape_->instructions().size()) {
    for (Slot s = 0; s < tape_->slotCount(); ++s)
        addresses_[s] = isUniform(s) ? &uniforms_[s - firstUniform_] : slot(s);
    for (const TapeLoop& loop : tape_->loops())
        loops_.push_back(std::make_unique<TapeWorkspace>(loop.body, components));
    loopAllowance_.fill(LoopRange::topAllowance);
}

void TapeWorkspace::setParameters(std::span<const double> parameters) {
    const std::vector<double> values = tape_->uniforms(parameters);
    std::copy(values.begin(), values.end(), uniforms_.begin());
    forgetSpread();
    for (const auto& loop : loops_) loop->setParameters(parameters);
}

void TapeWorkspace::limitDomains(const IntervalEvaluator& evaluator) {
    const std::span<const Instruction> instructions = tape_->instructions();
    for (std::size_t number = 0; number < instructions.size(); ++number)
        for (int k = 0; k < std::min<int>(instructions[number].operandCount, 2); ++k) {
            const Interval& range = evaluator.operandRange(number, k);
            // An operand that never has a value needs no limits.
            domains_[number][2 * k] = range.empty() ? -Interval::infinite : range.low;
            domains_[number][2 * k + 1] = range.empty() ? Interval::infinite : range.high;
        }
    for (std::uint32_t k = 0; k < loops_.size(); ++k) loops_[k]->limitDomains(evaluator.loop(k));
}

bool TapeWorkspace::isSpread(int operand, Slot slot, std::size_t lanes) {
    Spread& spread = spreads_[static_cast<std::size_t>(operand)];
    if (spread.slot == slot && spread.lanes >= lanes) return true;
    spread = {slot, lanes};
    return false;
}

double* TapeWorkspace::ownArgument(int index) {
    double* own = slot(static_cast<Slot>(index));
    addresses_[index] = own;
    return own;
}

}  // namespace isoscope
