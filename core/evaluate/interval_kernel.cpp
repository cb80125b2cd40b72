// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/interval_kernel.h"

#include <cfenv>

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/evaluate/interval_kernel.cpp"
#include <hwy/foreach_target.h>

#include "core/evaluate/algebra/interval_algebra-inl.h"
#include "core/evaluate/algebra/point_noise-inl.h"
#include "core/evaluate/algebra/tape_interpreter-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

void runIntervals(TapeWorkspace& workspace, std::span<const Instruction> instructions, std::size_t lanes) {
    TapeInterpreter<IntervalAlgebra, false>(workspace, lanes).run(instructions);
}

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(runIntervals);

UpwardRounding::UpwardRounding() { std::fesetround(FE_UPWARD); }
UpwardRounding::~UpwardRounding() { std::fesetround(FE_TONEAREST); }

void runIntervalInstructions(TapeWorkspace& workspace, std::span<const Instruction> instructions,
                             std::size_t lanes) {
    HWY_DYNAMIC_DISPATCH(runIntervals)(workspace, instructions, lanes);
}

}  // namespace isoscope
#endif
