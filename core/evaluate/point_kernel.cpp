// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/point_kernel.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/evaluate/point_kernel.cpp"
#include <hwy/foreach_target.h>

#include "core/evaluate/point_algebra-inl.h"
#include "core/evaluate/point_noise-inl.h"
#include "core/evaluate/tape_interpreter-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

void runPoints(TapeWorkspace& workspace, std::size_t lanes) {
    if (lanes == batchLanes)
        TapeInterpreter<PointAlgebra, true>(workspace, lanes).run();
    else
        TapeInterpreter<PointAlgebra, false>(workspace, lanes).run();
}

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(runPoints);

void runPointTape(TapeWorkspace& workspace, std::size_t lanes) {
    HWY_DYNAMIC_DISPATCH(runPoints)(workspace, lanes);
}

}  // namespace isoscope
#endif
