// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/tape/tape_workspace.h"

#include <algorithm>

#include "core/evaluate/tape/loop_range.h"

namespace isoscope {

namespace {

hwy::AlignedFreeUniquePtr<double[]> zeros(std::size_t count) {
    auto memory = hwy::AllocateAligned<double>(std::max<std::size_t>(count, 1));
    std::fill_n(memory.get(), count, 0.0);
    return memory;
}

}  // namespace

TapeWorkspace::TapeWorkspace(const Tape& tape, const UniformValues& uniforms, std::size_t components,
                             const OperandDomains* domains)
    : tape_(tape),
      components_(components),
      stride_(components * batchLanes),
      firstUniform_(tape.firstUniform()),
      skipped_(tape.uniformCount()),
      memory_(zeros((tape.slotCount() - skipped_) * stride_)),
      spread_(zeros(4 * stride_)),
      addresses_(tape.slotCount()),
      domains_(domains != nullptr ? domains->limits.data() : nullptr),
      choiceSides_(tape.instructions().size()) {
    for (Slot s = 0; s < tape.slotCount(); ++s)
        addresses_[s] = isUniform(s) ? &uniforms.values[s - firstUniform_] : slot(s);
    for (std::uint32_t k = 0; k < tape.loops().size(); ++k)
        loops_.push_back(std::make_unique<TapeWorkspace>(*tape.loop(k).body, uniforms.loops[k], components,
                                                         domains != nullptr ? &domains->loops[k] : nullptr));
    loopAllowance_.fill(LoopRange::topAllowance);
}

bool TapeWorkspace::isSpread(std::size_t operand, Slot slot, std::size_t lanes) {
    Spread& spread = spreads_[operand];
    if (spread.slot == slot && spread.lanes >= lanes) return true;
    spread = {slot, lanes};
    return false;
}

double* TapeWorkspace::ownArgument(int index) {
    double* own = slot(static_cast<Slot>(index));
    addresses_[static_cast<std::size_t>(index)] = own;
    return own;
}

}  // namespace isoscope
