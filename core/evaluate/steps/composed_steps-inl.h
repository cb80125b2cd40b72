// SPDX-License-Identifier: GPL-3.0-or-later
// Included once per instruction set. The machine that runs the steps of a StepProgram on numbers of several
// components; of use only where there are many registers.
#if defined(ISOSCOPE_EVALUATE_COMPOSED_STEPS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOSCOPE_EVALUATE_COMPOSED_STEPS_INL
#undef ISOSCOPE_EVALUATE_COMPOSED_STEPS_INL
#else
#define ISOSCOPE_EVALUATE_COMPOSED_STEPS_INL
#endif

#include <hwy/highway.h>

#include <iterator>

#include "core/evaluate/algebra/tape_interpreter-inl.h"
#include "core/evaluate/steps/step_machine-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

#if ISOSCOPE_MANY_REGISTERS
// clang-format off
#define ISOSCOPE_COMPOSED_STEPS(operation) ISOSCOPE_MEMORY_OPERANDS(ISOSCOPE_STEP, operation)
#define ISOSCOPE_COMPOSED_LABELS(operation) ISOSCOPE_MEMORY_OPERANDS(ISOSCOPE_LABEL, operation) nullptr, nullptr,
#define ISOSCOPE_CHOICE_STEPS(operation) ISOSCOPE_STEP(operation, lanes) ISOSCOPE_STEP(operation, uniform)
#define ISOSCOPE_CHOICE_LABELS(operation) \
    ISOSCOPE_LABEL(operation, lanes) nullptr, nullptr, nullptr, nullptr, ISOSCOPE_LABEL(operation, uniform) nullptr, nullptr,
#define ISOSCOPE_NO_LABELS nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr,
// clang-format on

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpedantic"  // as in point_steps-inl.h
/// Runs the steps up to an `end` on `vectors` vectors from lane `first` on.
template <class Algebra, std::size_t vectors>
HWY_NOINLINE void runComposedBlock(const ProgramStep* step, std::size_t first) {
    using Operations = StepOperations<Algebra>;
    // clang-format off
    static const void* const labels[] = {
        ISOSCOPE_COMPOSED_LABELS(load) ISOSCOPE_COMPOSED_LABELS(add) ISOSCOPE_COMPOSED_LABELS(subtract)
        ISOSCOPE_COMPOSED_LABELS(subtractFrom) ISOSCOPE_COMPOSED_LABELS(multiply)
        ISOSCOPE_COMPOSED_LABELS(multiplyInto)
        ISOSCOPE_NO_LABELS ISOSCOPE_NO_LABELS
        ISOSCOPE_CHOICE_LABELS(minimum) ISOSCOPE_CHOICE_LABELS(minimumFrom)
        ISOSCOPE_CHOICE_LABELS(maximum) ISOSCOPE_CHOICE_LABELS(maximumFrom)
        &&square, &&negate, &&absolute, nullptr, &&store, nullptr, nullptr, &&end};
    // clang-format on
    static_assert(std::size(labels) == ProgramStep::codeOf(StepOperation::end) + 1);
    StepMachine<Algebra, vectors> machine(first);
    goto* labels[step->code];
    ISOSCOPE_COMPOSED_STEPS(load)
    ISOSCOPE_COMPOSED_STEPS(add)
    ISOSCOPE_COMPOSED_STEPS(subtract)
    ISOSCOPE_COMPOSED_STEPS(subtractFrom)
    ISOSCOPE_COMPOSED_STEPS(multiply)
    ISOSCOPE_COMPOSED_STEPS(multiplyInto)
    ISOSCOPE_CHOICE_STEPS(minimum)
    ISOSCOPE_CHOICE_STEPS(minimumFrom)
    ISOSCOPE_CHOICE_STEPS(maximum)
    ISOSCOPE_CHOICE_STEPS(maximumFrom)
    ISOSCOPE_OWN_STEP(square)
    ISOSCOPE_OWN_STEP(negate)
    ISOSCOPE_OWN_STEP(absolute)
store:
    machine.accumulator.change([to = step->target + first](const auto& v, std::size_t k) ISOSCOPE_STEP_ATTR {
        Algebra::store(v, to + k * vectorLanes);
        return v;
    });
    ISOSCOPE_NEXT;
end:
    return;
}
#pragma GCC diagnostic pop

#undef ISOSCOPE_NO_LABELS
#undef ISOSCOPE_CHOICE_LABELS
#undef ISOSCOPE_CHOICE_STEPS
#undef ISOSCOPE_COMPOSED_LABELS
#undef ISOSCOPE_COMPOSED_STEPS
#endif  // ISOSCOPE_MANY_REGISTERS

/// Runs the steps of one stretch on at least the first `lanes` lanes. False where few registers make
/// instructions better, and nothing is run.
template <class Algebra, std::size_t vectors>
HWY_INLINE bool runComposedSteps([[maybe_unused]] const StepProgram& program,
                                 [[maybe_unused]] const StepProgram::Stretch& stretch,
                                 [[maybe_unused]] std::size_t lanes) {
#if ISOSCOPE_MANY_REGISTERS
    constexpr std::size_t block = vectors * vectorLanes;
    static_assert(batchLanes % block == 0);
    if (stretch.stepCount > 0)
        for (std::size_t first = 0; first < lanes; first += block)
            runComposedBlock<Algebra, vectors>(program.steps(stretch).data(), first);
    return true;
#else
    return false;
#endif
}

/// Runs a program on at least the first `lanes` lanes. `vectors` of the accumulator: enough to hide how long
/// one sum waits for the one before, and so few that they leave registers for a product of two numbers.
template <class Algebra, std::size_t vectors>
HWY_INLINE void runComposedProgram(TapeWorkspace& workspace, const StepProgram& program, std::size_t lanes) {
    TapeInterpreter<Algebra, false> interpreter(workspace, lanes);
#if ISOSCOPE_MANY_REGISTERS
    for (const StepProgram::Stretch& stretch : program.stretches()) {
        runComposedSteps<Algebra, vectors>(program, stretch, lanes);
        // Mostly there are none after the last: to find that out inside takes as long as some steps.
        if (!stretch.instructions.empty()) interpreter.run(stretch.instructions);
    }
#else
    // Few vectors at a time are slower than all of them instruction by instruction.
    interpreter.run(program.instructions());
#endif
}

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
