// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/affine_case_kernel.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/evaluate/affine_case_kernel.cpp"
#include <hwy/foreach_target.h>

#include "core/evaluate/algebra/affine_cases-inl.h"
#include "core/evaluate/algebra/tape_interpreter-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

void runCases(TapeWorkspace& workspace, std::span<const Instruction> instructions, CaseLanes& cases,
              std::size_t lanes) {
    TapeInterpreter<AffineCaseAlgebra, false>(workspace, lanes, AffineCaseAlgebra(&cases, &workspace))
        .run(instructions);
}

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(runCases);

void runAffineCases(TapeWorkspace& workspace, std::span<const Instruction> instructions, CaseLanes& cases,
                    std::size_t lanes) {
    cases.jumps.fill(0);
    cases.first.fill(1);
    cases.last.fill(1);
    if (!cases.bySides) cases.sides.fill(0);
    HWY_DYNAMIC_DISPATCH(runCases)(workspace, instructions, cases, lanes);
}

}  // namespace isoscope
#endif
