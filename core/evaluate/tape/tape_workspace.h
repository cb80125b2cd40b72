// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hwy/aligned_allocator.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "core/evaluate/tape/operand_domains.h"
#include "core/evaluate/tape/tape.h"
#include "core/evaluate/tape/uniform_values.h"

namespace isoscope {

/// Points per run of the interpreter; longer inputs are cut into runs of this many.
constexpr std::size_t batchLanes = 64;

/// The memory that one run of a tape needs, for numbers of `components` doubles: slot s holds component c of
/// lane i at slot(s)[c * batchLanes + i]. Uniform slots are read where `uniforms` has them. Loops have
/// workspaces of their own inside. One object per thread.
class TapeWorkspace {
  public:
    /// The tape, its uniform values and the domains of its operands (may be null: not known) are shared, and
    /// must outlive the workspace.
    TapeWorkspace(const Tape& tape, const UniformValues& uniforms, std::size_t components,
                  const OperandDomains* domains = nullptr);

    /// The tape it is for, and the doubles that make up one number.
    const Tape& tape() const { return tape_; }
    std::size_t components() const { return components_; }

    /// Memory of an argument or of a reused slot.
    double* slot(Slot slot) {
        return memory_.get() + (slot < firstUniform_ ? slot : slot - skipped_) * stride_;
    }

    /// Where the values of a slot are read: own memory, memory of the caller for arguments (pointTo), or the
    /// single value of a uniform slot.
    const double* address(Slot slot) const { return addresses_[slot]; }
    /// Whether a slot holds one number for all lanes, and that number; uniform() is for no other slots.
    bool isUniform(Slot slot) const { return slot - firstUniform_ < skipped_; }
    double uniform(Slot slot) const { return *addresses_[slot]; }

    /// Reads argument `index` from the memory of the caller during the next run.
    void pointTo(int index, const double* lanes) { addresses_[static_cast<std::size_t>(index)] = lanes; }
    /// Reads argument `index` from the workspace's own memory again.
    double* ownArgument(int index);

    /// Room for uniform operand `operand` (0 to 3) of an instruction, spread over the lanes.
    double* spread(std::size_t operand) { return spread_.get() + operand * stride_; }
    /// Whether the value of a uniform slot is spread there over so many lanes already; if not, the caller is
    /// to do that now. Loops of noises want the same few again and again.
    bool isSpread(std::size_t operand, Slot slot, std::size_t lanes);
    /// Room for two numbers of all lanes, between instructions.
    double* scratch() {
        forgetSpread();
        return spread_.get();
    }

    /// What the first two operands of an instruction can be at all: low and high of the first, then of the
    /// second. Only for workspaces that were given domains.
    const double* operandDomains(std::size_t instruction) const { return domains_[instruction].data(); }

    /// Which operands a choosing instruction has taken in some lane since forgetChoices(): 1 for the first, 2
    /// for the second. Kept by the interval kernel.
    std::uint8_t* choiceSides(std::size_t instruction) { return &choiceSides_[instruction]; }
    /// Begins anew what choiceSides() collects; loop bodies keep theirs.
    void forgetChoices() { std::fill(choiceSides_.begin(), choiceSides_.end(), std::uint8_t{0}); }

    /// The workspace of the body of loop `index` of the tape, with as many components.
    TapeWorkspace& loop(std::uint32_t index) { return *loops_[index]; }

    /// Steps that loops may run, per lane (see LoopRange).
    std::array<double, batchLanes>& loopAllowance() { return loopAllowance_; }
    const std::array<double, batchLanes>& loopAllowance() const { return loopAllowance_; }

  private:
    /// What is in the room of a spread operand.
    struct Spread {
        Slot slot = 0;
        std::size_t lanes = 0;
    };
    void forgetSpread() { spreads_.fill({}); }

    const Tape& tape_;
    std::size_t components_;
    std::size_t stride_;
    Slot firstUniform_;
    Slot skipped_;  ///< number of uniform slots, which take no lane memory
    hwy::AlignedFreeUniquePtr<double[]> memory_;
    hwy::AlignedFreeUniquePtr<double[]> spread_;
    std::array<Spread, 4> spreads_;
    std::vector<const double*> addresses_;
    const OperandDomains::Limits* domains_;  ///< of each instruction
    std::vector<std::uint8_t> choiceSides_;
    std::vector<std::unique_ptr<TapeWorkspace>> loops_;
    std::array<double, batchLanes> loopAllowance_;
};

}  // namespace isoscope
