// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/point_kernel.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/evaluate/point_kernel.cpp"
#include <hwy/foreach_target.h>

#include "core/evaluate/algebra/point_algebra-inl.h"
#include "core/evaluate/algebra/point_noise-inl.h"
#include "core/evaluate/algebra/tape_interpreter-inl.h"
#include "core/evaluate/steps/point_steps-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

void runPoints(TapeWorkspace& workspace, std::span<const Instruction> instructions, std::size_t lanes) {
    TapeInterpreter<PointAlgebra, false>(workspace, lanes).run(instructions);
}

void runStretches(TapeWorkspace& workspace, const StepProgram& program) {
    TapeInterpreter<PointAlgebra, true> interpreter(workspace, batchLanes);
    for (const StepProgram::Stretch& stretch : program.stretches()) {
        // Copies in registers leave the room as it is.
        if (stretch.stepCount > 0)
            runPointSteps(program.steps(stretch).data(),
                          ISOSCOPE_MANY_REGISTERS ? workspace.spread(0) : workspace.scratch());
        // Mostly there are none after the last: to find that out inside takes as long as some steps.
        if (!stretch.instructions.empty()) interpreter.run(stretch.instructions);
    }
}

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(runPoints);
HWY_EXPORT(runStretches);

void runPointTape(TapeWorkspace& workspace, std::size_t lanes) {
    runPointInstructions(workspace, workspace.tape().instructions(), lanes);
}

void runPointInstructions(TapeWorkspace& workspace, std::span<const Instruction> instructions,
                          std::size_t lanes) {
    HWY_DYNAMIC_DISPATCH(runPoints)(workspace, instructions, lanes);
}

void runPointProgram(TapeWorkspace& workspace, const StepProgram& program) {
    HWY_DYNAMIC_DISPATCH(runStretches)(workspace, program);
}

}  // namespace isoscope
#endif
