// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/affine_kernel.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/evaluate/affine_kernel.cpp"
#include <hwy/foreach_target.h>

#include "core/evaluate/affine_algebra-inl.h"
#include "core/evaluate/tape_interpreter-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

void runAffineForms(TapeWorkspace& workspace, std::span<const Instruction> instructions, std::size_t lanes) {
    // A number of three or four vectors leaves little to gain from a fixed count of lanes.
    TapeInterpreter<AffineAlgebra, false>(workspace, lanes).run(instructions);
}

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(runAffineForms);

void runAffineTape(TapeWorkspace& workspace, std::size_t lanes) {
    runAffineInstructions(workspace, workspace.tape().instructions(), lanes);
}

void runAffineInstructions(TapeWorkspace& workspace, std::span<const Instruction> instructions,
                           std::size_t lanes) {
    HWY_DYNAMIC_DISPATCH(runAffineForms)(workspace, instructions, lanes);
}

}  // namespace isoscope
#endif
