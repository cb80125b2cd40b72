// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/affine_case_kernel.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/evaluate/affine_case_kernel.cpp"
#include <hwy/foreach_target.h>

#include <array>

#include "core/evaluate/jumps/affine_cases-inl.h"
#include "core/evaluate/jumps/affine_sides-inl.h"
#include "core/evaluate/affine_kernel.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

/// An instruction with this operation, which the algebra covers. There is a loop for each operation: one for
/// all of them would keep its operands in memory.
template <Operation operation, class Algebra>
HWY_NOINLINE void runOperation(TapeWorkspace& workspace, const Instruction& instruction, Algebra& algebra,
                               std::size_t lanes) {
    using Number = typename Algebra::Number;
    constexpr std::size_t count = arity(operation);
    std::array<const double*, 4> places{};
    std::array<Number, 4> uniforms{};
    for (std::size_t k = 0; k < count; ++k) {
        const Slot slot = instruction.operands[k];
        if (workspace.isUniform(slot))
            uniforms[k] = Algebra::widen(Algebra::uniform(workspace.uniform(slot)));
        else
            places[k] = workspace.address(slot);
    }
    double* const target = workspace.slot(instruction.target);
    for (std::size_t lane = 0; lane < lanes; lane += hn::Lanes(Doubles())) {
        std::array<Number, 4> operands;
        for (std::size_t k = 0; k < count; ++k)
            operands[k] = places[k] != nullptr ? Algebra::load(places[k] + lane) : uniforms[k];
        Algebra::store(algebra.run(operation, operands, lane), target + lane);
    }
}

/// The same for an operation that is known at run time.
template <class Algebra>
void runCovered(TapeWorkspace& workspace, const Instruction& instruction, Algebra& algebra,
                std::size_t lanes) {
    algebra.begin(workspace, instruction.number);
    Algebra::withCovered(instruction.operation, [&](auto operation) HWY_ATTR {
        runOperation<operation()>(workspace, instruction, algebra, lanes);
    });
}

/// Jumps, and what may come to whole numbers, by the algebra; the rest is run as ever.
template <class Algebra>
void runByAlgebra(TapeWorkspace& workspace, std::span<const Instruction> instructions, Algebra& algebra,
                  const std::vector<bool>& isWhole, std::size_t lanes, bool wholeCoordinates) {
    std::size_t begun = 0;
    for (std::size_t k = 0; k < instructions.size(); ++k) {
        const Operation operation = instructions[k].operation;
        const bool covered = wholeCoordinates ? Algebra::covers(operation)
                                              : hasSides(operation) || isWhole[instructions[k].number];
        if (!covered) continue;
        if (begun < k) runAffineInstructions(workspace, instructions.subspan(begun, k - begun), lanes);
        runCovered(workspace, instructions[k], algebra, lanes);
        begun = k + 1;
    }
    if (begun < instructions.size()) runAffineInstructions(workspace, instructions.subspan(begun), lanes);
}

/// The same by a program; false, without effect, where instructions are better.
template <class Algebra>
bool runProgram(TapeWorkspace& workspace, const StepProgram& program, Algebra& algebra,
                const std::vector<bool>& isWhole, std::size_t lanes) {
    for (const StepProgram::Stretch& stretch : program.stretches()) {
        if (!runAffineSteps(workspace, program, stretch, lanes)) return false;
        if (!stretch.instructions.empty())
            runByAlgebra(workspace, stretch.instructions, algebra, isWhole, lanes, false);
    }
    return true;
}

void runCases(TapeWorkspace& workspace, std::span<const Instruction> instructions, CaseLanes& cases,
              std::size_t lanes, bool wholeCoordinates) {
    AffineCaseAlgebra algebra(cases);
    runByAlgebra(workspace, instructions, algebra, cases.isWhole, lanes, wholeCoordinates);
}
bool runCaseProgram(TapeWorkspace& workspace, const StepProgram& program, CaseLanes& cases,
                    std::size_t lanes) {
    AffineCaseAlgebra algebra(cases);
    return runProgram(workspace, program, algebra, cases.isWhole, lanes);
}

void runSides(TapeWorkspace& workspace, std::span<const Instruction> instructions, SideLanes& sides,
              std::size_t lanes, bool wholeCoordinates) {
    AffineSideAlgebra algebra(sides, lanes);
    runByAlgebra(workspace, instructions, algebra, sides.isWhole, lanes, wholeCoordinates);
}
bool runSideProgram(TapeWorkspace& workspace, const StepProgram& program, SideLanes& sides,
                    std::size_t lanes) {
    AffineSideAlgebra algebra(sides, lanes);
    return runProgram(workspace, program, algebra, sides.isWhole, lanes);
}

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(runCases);
HWY_EXPORT(runCaseProgram);
HWY_EXPORT(runSides);
HWY_EXPORT(runSideProgram);

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
    return HWY_DYNAMIC_DISPATCH(runCaseProgram)(workspace, program, cases, lanes);
}

void runAffineSides(TapeWorkspace& workspace, std::span<const Instruction> instructions, SideLanes& sides,
                    std::size_t lanes, bool wholeCoordinates) {
    HWY_DYNAMIC_DISPATCH(runSides)(workspace, instructions, sides, lanes, wholeCoordinates);
}

bool runAffineSides(TapeWorkspace& workspace, const StepProgram& program, SideLanes& sides,
                    std::size_t lanes) {
    return HWY_DYNAMIC_DISPATCH(runSideProgram)(workspace, program, sides, lanes);
}

}  // namespace isoscope
#endif
