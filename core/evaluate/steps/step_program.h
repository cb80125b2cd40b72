// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/evaluate/steps/step_code.h"
#include "core/evaluate/tape/tape_workspace.h"

namespace isoscope {

/// A StepCode, bound to the memory of a workspace. The results are, bit by bit, those of the instructions one
/// after the other. One object per thread.
class StepProgram {
  public:
    using Stretch = StepCode::Stretch;

    /// The kind of number that a workspace holds.
    static StepNumberKind numbersOf(const TapeWorkspace& workspace) {
        return workspace.components() == 1 ? StepNumberKind::plain : StepNumberKind::composed;
    }

    /// For a code of the workspace's tape and numbers. Reads and writes the memory of this workspace; both
    /// must outlive the program (the workspace may be moved).
    StepProgram(TapeWorkspace& workspace, const StepCode& code);

    /// Reads the arguments from where the workspace has them now, and writes into the workspace.
    void bind(TapeWorkspace& workspace);

    /// Writes the value of a slot to the memory of the caller, not to the workspace, until bind(). False,
    /// without effect, when it is not the last thing the program writes.
    bool writeTo(Slot slot, double* lanes);

    /// What it was made from.
    const StepCode& code() const { return *code_; }
    std::span<const Instruction> instructions() const { return code_->instructions(); }

    /// The stretches in the order they run, and the steps of one of them, without its `end`. Valid while the
    /// program lives.
    std::span<const Stretch> stretches() const { return code_->stretches(); }
    std::span<const ProgramStep> steps(const Stretch& stretch) const {
        return std::span(steps_).subspan(stretch.firstStep, stretch.stepCount);
    }

  private:
    static void bind(ProgramStep& step, TapeWorkspace& workspace);

    const StepCode* code_;
    std::vector<ProgramStep> steps_;         ///< those of the code, bound
    std::vector<const double*> arguments_;   ///< where the movable ones read the arguments
    std::size_t last_ = 0;                   ///< the step that writes last, if there is one
    Slot lastStored_ = ProgramStep::unused;  ///< what it writes
    double* ownTarget_ = nullptr;            ///< and where, unless the caller wants it elsewhere
};

}  // namespace isoscope
