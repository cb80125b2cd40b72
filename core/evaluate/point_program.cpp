// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/point_program.h"

#include "core/evaluate/point_program_compiler.h"

namespace isoscope {

PointProgram::PointProgram(TapeWorkspace& workspace) {
    const Tape& tape = workspace.tape();
    // Mostly enough; growing would touch the memory twice.
    steps_.reserve(tape.instructions().size());
    PointProgramCompiler(tape, steps_, stretches_).compile();
    for (std::uint32_t k = 0; k < steps_.size(); ++k) {
        bind(steps_[k], workspace);
        if (tape.isArgument(steps_[k].a) || tape.isArgument(steps_[k].b)) movable_.push_back(k);
    }
    if (stretches_.back().stepCount > 0) movable_.push_back(static_cast<std::uint32_t>(steps_.size() - 1));
}

void PointProgram::bind(PointStep& step, TapeWorkspace& workspace) {
    if (step.code == PointCode::store) {
        step.target = workspace.slot(step.a);
        return;
    }
    if (step.a != PointStep::unused) step.lanesA = workspace.address(step.a);
    if (step.b != PointStep::unused) step.lanesB = workspace.address(step.b);
}

void PointProgram::bind(TapeWorkspace& workspace) {
    for (const std::uint32_t k : movable_) bind(steps_[k], workspace);
}

bool PointProgram::writeTo(Slot slot, double* lanes) {
    if (stretches_.back().stepCount == 0 || steps_.back().a != slot) return false;
    steps_.back().target = lanes;
    return true;
}

}  // namespace isoscope
