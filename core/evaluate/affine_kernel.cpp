// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/affine_kernel.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/evaluate/affine_kernel.cpp"
#include <hwy/foreach_target.h>

#include <algorithm>
#include <array>

#include "core/evaluate/algebra/affine_algebra-inl.h"
#include "core/evaluate/algebra/tape_interpreter-inl.h"
#include "core/evaluate/ray_piece_forms-inl.h"
#include "core/evaluate/steps/composed_steps-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

void runAffineForms(TapeWorkspace& workspace, std::span<const Instruction> instructions, std::size_t lanes) {
    // A number of three or four vectors leaves little to gain from a fixed count of lanes.
    if (workspace.tape().multipliesRanges())
        TapeInterpreter<AffineRangeAlgebra, false>(workspace, lanes).run(instructions);
    else
        TapeInterpreter<AffineAlgebra, false>(workspace, lanes).run(instructions);
}

void runStretches(TapeWorkspace& workspace, const StepProgram& program, const PieceColumns& pieces,
                  const RaySpread* spread, std::size_t lanes) {
    std::array<double*, 3> places{};
    const auto arguments = static_cast<std::size_t>(std::min(3, workspace.tape().argumentCount()));
    for (std::size_t k = 0; k < arguments; ++k) places[k] = workspace.slot(static_cast<Slot>(k));
    writeForms(pieces, spread, lanes, std::span(places).first(arguments));
    if (workspace.tape().multipliesRanges())
        runComposedProgram<AffineRangeAlgebra, 4>(workspace, program, lanes);
    else
        runComposedProgram<AffineAlgebra, 4>(workspace, program, lanes);
}

bool runSteps(const TapeWorkspace& workspace, const StepProgram& program, const StepProgram::Stretch& stretch,
              std::size_t lanes) {
    return workspace.tape().multipliesRanges()
               ? runComposedSteps<AffineRangeAlgebra, 4>(program, stretch, lanes)
               : runComposedSteps<AffineAlgebra, 4>(program, stretch, lanes);
}

void widenForms(const AffineLanes& forms, double offset, double error, std::size_t count, double* centers,
                double* errors) {
    const Doubles d;
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        const AffineNumber form{hn::LoadU(d, forms.center + i), hn::Zero(d), hn::LoadU(d, forms.error + i)};
        const AffineNumber sum =
            sumOf(form, AffineNumber{constantVector(offset), hn::Zero(d), constantVector(error)});
        hn::StoreU(sum.a, d, centers + i);
        hn::StoreU(sum.e, d, errors + i);
    }
}

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(runAffineForms);
HWY_EXPORT(runStretches);
HWY_EXPORT(runSteps);
HWY_EXPORT(widenForms);

void runAffineTape(TapeWorkspace& workspace, std::size_t lanes) {
    runAffineInstructions(workspace, workspace.tape().instructions(), lanes);
}

void runAffineInstructions(TapeWorkspace& workspace, std::span<const Instruction> instructions,
                           std::size_t lanes) {
    HWY_DYNAMIC_DISPATCH(runAffineForms)(workspace, instructions, lanes);
}

void runAffineProgram(TapeWorkspace& workspace, const StepProgram& program, const PieceColumns& pieces,
                      const RaySpread* spread, std::size_t lanes) {
    HWY_DYNAMIC_DISPATCH(runStretches)(workspace, program, pieces, spread, lanes);
}

bool runAffineSteps(const TapeWorkspace& workspace, const StepProgram& program,
                    const StepProgram::Stretch& stretch, std::size_t lanes) {
    return HWY_DYNAMIC_DISPATCH(runSteps)(workspace, program, stretch, lanes);
}

void widenAffineForms(const AffineLanes& forms, double offset, double error, std::size_t count,
                      double* centers, double* errors) {
    HWY_DYNAMIC_DISPATCH(widenForms)(forms, offset, error, count, centers, errors);
}

}  // namespace isoscope
#endif
