// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/gradient_kernel.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/evaluate/gradient_kernel.cpp"
#include <hwy/foreach_target.h>

#include "core/evaluate/gradient_algebra-inl.h"
#include "core/evaluate/tape_interpreter-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

void runGradients(TapeWorkspace& workspace, std::span<const Instruction> instructions, std::size_t lanes) {
    // A number of three or four vectors leaves little to gain from a fixed count of lanes.
    TapeInterpreter<GradientAlgebra, false>(workspace, lanes).run(instructions);
}

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(runGradients);

void runGradientTape(TapeWorkspace& workspace, std::size_t lanes) {
    runGradientInstructions(workspace, workspace.tape().instructions(), lanes);
}

void runGradientInstructions(TapeWorkspace& workspace, std::span<const Instruction> instructions,
                             std::size_t lanes) {
    HWY_DYNAMIC_DISPATCH(runGradients)(workspace, instructions, lanes);
}

}  // namespace isoscope
#endif
