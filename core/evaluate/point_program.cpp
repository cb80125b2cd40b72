// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/point_program.h"

#include "core/evaluate/point_program_compiler.h"

namespace isoscope {

namespace {

/// The steps only read where they must not write: arguments and uniform slots.
double* lanes(const TapeWorkspace& workspace, Slot slot) {
    return slot == PointStep::unused ? nullptr : const_cast<double*>(workspace.address(slot));
}

}  // namespace

PointProgram::PointProgram(TapeWorkspace& workspace) {
    const Tape& tape = workspace.tape();
    PointProgramCompiler(tape, steps_, stretches_).compile();
    for (std::uint32_t k = 0; k < steps_.size(); ++k) {
        bind(steps_[k], workspace);
        if (tape.isArgument(steps_[k].a) || tape.isArgument(steps_[k].b)) movable_.push_back(k);
    }
    if (stretches_.back().stepCount > 0) movable_.push_back(static_cast<std::uint32_t>(steps_.size() - 1));
}

void PointProgram::bind(PointStep& step, const TapeWorkspace& workspace) {
    step.lanesA = lanes(workspace, step.a);
    step.lanesB = lanes(workspace, step.b);
}

void PointProgram::bind(const TapeWorkspace& workspace) {
    for (const std::uint32_t k : movable_) bind(steps_[k], workspace);
}

bool PointProgram::writeTo(Slot slot, double* lanes) {
    if (stretches_.back().stepCount == 0 || steps_.back().a != slot) return false;
    steps_.back().lanesA = lanes;
    return true;
}

}  // namespace isoscope
