// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/steps/step_program.h"

namespace isoscope {

namespace {

constexpr std::uint8_t storeCode = ProgramStep::codeOf(StepOperation::store);

}  // namespace

StepProgram::StepProgram(TapeWorkspace& workspace, const StepCode& code)
    : code_(&code), steps_(code.steps().begin(), code.steps().end()) {
    for (ProgramStep& step : steps_) bind(step, workspace);
    const Tape& tape = code.tape();
    for (int k = 0; k < tape.argumentCount(); ++k)
        arguments_.push_back(workspace.address(static_cast<Slot>(k)));
    const Stretch& end = stretches().back();
    if (end.stepCount == 0) return;
    const std::size_t last = end.firstStep + end.stepCount - 1;
    if (steps_[last].code != storeCode) return;
    last_ = last;
    lastStored_ = steps_[last].a;
    ownTarget_ = steps_[last].target;
}

void StepProgram::bind(ProgramStep& step, TapeWorkspace& workspace) {
    if (step.code == storeCode) {
        step.target = workspace.slot(step.a);
        return;
    }
    if (step.a != ProgramStep::unused) step.lanesA = workspace.address(step.a);
    if (step.b != ProgramStep::unused) step.lanesB = workspace.address(step.b);
}

void StepProgram::bind(TapeWorkspace& workspace) {
    bool moved = false;
    for (std::size_t k = 0; k < arguments_.size(); ++k) {
        const double* const lanes = workspace.address(static_cast<Slot>(k));
        moved = moved || lanes != arguments_[k];
        arguments_[k] = lanes;
    }
    // Callers mostly ask from the same memory again.
    if (moved)
        for (const std::uint32_t k : code_->movable()) bind(steps_[k], workspace);
    if (ownTarget_ != nullptr) steps_[last_].target = ownTarget_;
}

bool StepProgram::writeTo(Slot slot, double* lanes) {
    if (slot != lastStored_) return false;
    steps_[last_].target = lanes;
    return true;
}

}  // namespace isoscope
