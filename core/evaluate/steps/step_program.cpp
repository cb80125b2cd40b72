// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/steps/step_program.h"

#include "core/evaluate/steps/step_program_compiler.h"

namespace isoscope {

namespace {

constexpr std::uint8_t storeCode = ProgramStep::codeOf(StepOperation::store);

}  // namespace

StepProgram::StepProgram(TapeWorkspace& workspace)
    : StepProgram(workspace, workspace.tape().instructions(), workspace.tape().results()) {}

StepProgram::StepProgram(TapeWorkspace& workspace, std::span<const Instruction> instructions,
                         std::span<const Slot> results)
    : instructions_(instructions) {
    const Tape& tape = workspace.tape();
    // Mostly enough; growing would touch the memory twice.
    steps_.reserve(instructions.size() + 1);
    const auto numbers = workspace.components() == 1 ? StepProgramCompiler::Numbers::plain
                                                     : StepProgramCompiler::Numbers::composed;
    StepProgramCompiler(tape, instructions, numbers, steps_, stretches_).compile(results);
    for (std::uint32_t k = 0; k < steps_.size(); ++k) {
        bind(steps_[k], workspace);
        if (tape.isArgument(steps_[k].a) || tape.isArgument(steps_[k].b)) movable_.push_back(k);
    }
    for (int k = 0; k < tape.argumentCount(); ++k)
        arguments_.push_back(workspace.address(static_cast<Slot>(k)));
    const Stretch& end = stretches_.back();
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
        for (const std::uint32_t k : movable_) bind(steps_[k], workspace);
    if (ownTarget_ != nullptr) steps_[last_].target = ownTarget_;
}

bool StepProgram::writeTo(Slot slot, double* lanes) {
    if (slot != lastStored_) return false;
    steps_[last_].target = lanes;
    return true;
}

}  // namespace isoscope
