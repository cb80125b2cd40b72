// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/affine_case_kernel.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/evaluate/affine_case_kernel.cpp"
#include <hwy/foreach_target.h>

#include <array>

#include "core/evaluate/algebra/affine_cases-inl.h"
#include "core/evaluate/affine_kernel.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

/// One instruction that AffineCaseAlgebra covers.
void runCase(TapeWorkspace& workspace, const Instruction& instruction, AffineCaseAlgebra& algebra,
             std::size_t lanes) {
    using Number = AffineCaseAlgebra::Number;
    algebra.begin(workspace, instruction.number);
    const auto operand = [&](int k, std::size_t lane) HWY_ATTR {
        const Slot slot = instruction.operands[k];
        if (!workspace.isUniform(slot)) return AffineCaseAlgebra::load(workspace.address(slot) + lane);
        return AffineCaseAlgebra::widen(AffineCaseAlgebra::uniform(workspace.uniform(slot)));
    };
    double* const target = workspace.slot(instruction.target);
    for (std::size_t lane = 0; lane < lanes; lane += hn::Lanes(Doubles())) {
        std::array<Number, 4> operands;
        for (int k = 0; k < instruction.operandCount; ++k) operands[k] = operand(k, lane);
        AffineCaseAlgebra::store(algebra.run(instruction.operation, operands, lane), target + lane);
    }
}

/// Jumps and what may come to whole numbers; the rest is run as ever.
void runCases(TapeWorkspace& workspace, std::span<const Instruction> instructions, CaseLanes& cases,
              std::size_t lanes, bool wholeCoordinates) {
    AffineCaseAlgebra algebra(cases);
    std::size_t begun = 0;
    for (std::size_t k = 0; k < instructions.size(); ++k) {
        const Operation operation = instructions[k].operation;
        const bool byCases = wholeCoordinates ? AffineCaseAlgebra::covers(operation)
                                              : hasSides(operation) || cases.isWhole[instructions[k].number];
        if (!byCases) continue;
        if (begun < k) runAffineInstructions(workspace, instructions.subspan(begun, k - begun), lanes);
        runCase(workspace, instructions[k], algebra, lanes);
        begun = k + 1;
    }
    if (begun < instructions.size()) runAffineInstructions(workspace, instructions.subspan(begun), lanes);
}

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(runCases);

namespace {

void clearAnswers(CaseLanes& cases) {
    cases.jump.fill(CaseLanes::noJump);
    cases.firstLow.fill(1);
    cases.firstHigh.fill(1);
}

}  // namespace

void runAffineCases(TapeWorkspace& workspace, std::span<const Instruction> instructions, CaseLanes& cases,
                    std::size_t lanes, bool wholeCoordinates) {
    clearAnswers(cases);
    HWY_DYNAMIC_DISPATCH(runCases)(workspace, instructions, cases, lanes, wholeCoordinates);
}

bool runAffineCases(TapeWorkspace& workspace, const StepProgram& program, CaseLanes& cases,
                    std::size_t lanes) {
    clearAnswers(cases);
    for (const StepProgram::Stretch& stretch : program.stretches()) {
        if (!runAffineSteps(program, stretch, lanes)) return false;
        if (!stretch.instructions.empty())
            HWY_DYNAMIC_DISPATCH(runCases)(workspace, stretch.instructions, cases, lanes, false);
    }
    return true;
}

}  // namespace isoscope
#endif
