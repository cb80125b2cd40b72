// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/gradient_kernel.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/evaluate/gradient_kernel.cpp"
#include <hwy/foreach_target.h>

#include "core/evaluate/algebra/gradient_algebra-inl.h"
#include "core/evaluate/algebra/tape_interpreter-inl.h"
#include "core/evaluate/steps/composed_steps-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

void runGradients(TapeWorkspace& workspace, std::span<const Instruction> instructions, std::size_t lanes) {
    // A number of three or four vectors leaves little to gain from a fixed count of lanes.
    TapeInterpreter<GradientAlgebra, false>(workspace, lanes).run(instructions);
}

void runStretches(TapeWorkspace& workspace, const StepProgram& program, std::size_t lanes) {
    runComposedProgram<GradientAlgebra, 4>(workspace, program, lanes);
}

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(runGradients);
HWY_EXPORT(runStretches);

void runGradientTape(TapeWorkspace& workspace, std::size_t lanes) {
    runGradientInstructions(workspace, workspace.tape().instructions(), lanes);
}

void runGradientInstructions(TapeWorkspace& workspace, std::span<const Instruction> instructions,
                             std::size_t lanes) {
    HWY_DYNAMIC_DISPATCH(runGradients)(workspace, instructions, lanes);
}

void runGradientProgram(TapeWorkspace& workspace, const StepProgram& program, std::size_t lanes) {
    HWY_DYNAMIC_DISPATCH(runStretches)(workspace, program, lanes);
}

}  // namespace isoscope
#endif
