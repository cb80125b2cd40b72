// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/taylor_kernel.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/evaluate/taylor_kernel.cpp"
#include <hwy/foreach_target.h>

#include <algorithm>

#include "core/evaluate/algebra/taylor_algebra-inl.h"
#include "core/evaluate/algebra/tape_interpreter-inl.h"
#include "core/evaluate/steps/composed_steps-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {
namespace {

void writeTangents(const RayPlaces& places, std::size_t lanes, std::span<double* const> arguments) {
    for (std::size_t axis = 0; axis < arguments.size(); ++axis) {
        for (std::size_t i = 0; i < lanes; i += vectorLanes) {
            const auto at = [i](const double* column) HWY_ATTR { return hn::LoadU(Doubles(), column + i); };
            const Vector direction = at(places.direction[axis]);
            const Vector way = hn::Mul(at(places.t), direction);
            const Vector value = hn::Add(at(places.origin[axis]), way);
            const Vector slope = hn::Mul(at(places.reach), direction);
            // Each of the three is rounded.
            const Vector greatest = hn::Add(hn::Abs(value), hn::Add(hn::Abs(way), hn::Abs(slope)));
            const Vector rounding =
                hn::MulAdd(greatest, constantVector(roundingUnit), constantVector(underflow));
            double* const argument = arguments[axis] + i;
            hn::StoreU(value, Doubles(), argument);
            hn::StoreU(slope, Doubles(), argument + 4 * batchLanes);
            hn::StoreU(rounding, Doubles(), argument + 6 * batchLanes);
        }
    }
}

void runTangents(TapeWorkspace& workspace, std::span<const Instruction> instructions, std::size_t lanes) {
    TapeInterpreter<TaylorAlgebra, false>(workspace, lanes).run(instructions);
}

void runStretches(TapeWorkspace& workspace, const StepProgram& program, std::size_t lanes) {
    runComposedProgram<TaylorAlgebra, 2>(workspace, program, lanes);
}

}  // namespace
}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(writeTangents);
HWY_EXPORT(runTangents);
HWY_EXPORT(runStretches);

void writeTangentArguments(const RayPlaces& places, std::size_t lanes, TapeWorkspace& workspace) {
    const auto count = static_cast<std::size_t>(std::min(3, workspace.tape().argumentCount()));
    std::array<double*, 3> arguments{};
    for (std::size_t k = 0; k < count; ++k) arguments[k] = workspace.slot(static_cast<Slot>(k));
    HWY_DYNAMIC_DISPATCH(writeTangents)(places, lanes, std::span(arguments).first(count));
}

void runTangentInstructions(TapeWorkspace& workspace, std::span<const Instruction> instructions,
                            std::size_t lanes) {
    HWY_DYNAMIC_DISPATCH(runTangents)(workspace, instructions, lanes);
}

void runTangentProgram(TapeWorkspace& workspace, const StepProgram& program, std::size_t lanes) {
    HWY_DYNAMIC_DISPATCH(runStretches)(workspace, program, lanes);
}

}  // namespace isoscope
#endif
