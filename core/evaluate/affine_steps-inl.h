// SPDX-License-Identifier: GPL-3.0-or-later
// Included once per instruction set. The machine that runs the steps of a StepProgram on affine forms; of use
// only where there are many registers.
#if defined(ISOSCOPE_EVALUATE_AFFINE_STEPS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOSCOPE_EVALUATE_AFFINE_STEPS_INL
#undef ISOSCOPE_EVALUATE_AFFINE_STEPS_INL
#else
#define ISOSCOPE_EVALUATE_AFFINE_STEPS_INL
#endif

#include <hwy/highway.h>

#include <iterator>

#include "core/evaluate/affine_algebra-inl.h"
#include "core/evaluate/step_machine-inl.h"

#if ISOSCOPE_MANY_REGISTERS
HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

// clang-format off
#define ISOSCOPE_AFFINE_STEPS(operation) ISOSCOPE_MEMORY_OPERANDS(ISOSCOPE_STEP, operation)
#define ISOSCOPE_AFFINE_LABELS(operation) ISOSCOPE_MEMORY_OPERANDS(ISOSCOPE_LABEL, operation) nullptr, nullptr,
#define ISOSCOPE_NO_LABELS nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr,
// clang-format on

/// Vectors of the accumulator: enough to hide how long one sum waits for the one before, and so few that they
/// leave registers for a product of two forms.
constexpr std::size_t affineVectors = 4;

/// Runs the steps up to an `end` on the vectors from lane `first` on.
HWY_NOINLINE void runAffineBlock(const ProgramStep* step, std::size_t first) {
    using Algebra = AffineAlgebra;
    using Operations = StepOperations<Algebra>;
    // clang-format off
    static const void* const labels[] = {
        ISOSCOPE_AFFINE_LABELS(load) ISOSCOPE_AFFINE_LABELS(add) ISOSCOPE_AFFINE_LABELS(subtract)
        ISOSCOPE_AFFINE_LABELS(subtractFrom) ISOSCOPE_AFFINE_LABELS(multiply)
        ISOSCOPE_AFFINE_LABELS(multiplyInto)
        ISOSCOPE_NO_LABELS ISOSCOPE_NO_LABELS ISOSCOPE_NO_LABELS
        ISOSCOPE_NO_LABELS ISOSCOPE_NO_LABELS ISOSCOPE_NO_LABELS
        &&square, &&negate, nullptr, nullptr, &&store, nullptr, nullptr, &&end};
    // clang-format on
    static_assert(std::size(labels) == ProgramStep::codeOf(StepOperation::end) + 1);
    StepMachine<Algebra, affineVectors> machine(first);
    goto* labels[step->code];
    ISOSCOPE_AFFINE_STEPS(load)
    ISOSCOPE_AFFINE_STEPS(add)
    ISOSCOPE_AFFINE_STEPS(subtract)
    ISOSCOPE_AFFINE_STEPS(subtractFrom)
    ISOSCOPE_AFFINE_STEPS(multiply)
    ISOSCOPE_AFFINE_STEPS(multiplyInto)
    ISOSCOPE_OWN_STEP(square)
    ISOSCOPE_OWN_STEP(negate)
store:
    machine.accumulator.change([to = step->target + first](const AffineNumber& v, std::size_t k)
                                   ISOSCOPE_STEP_ATTR {
                                       Algebra::store(v, to + k * vectorLanes);
                                       return v;
                                   });
    ISOSCOPE_NEXT;
end:
    return;
}

/// Runs the steps up to an `end` on at least the first `lanes` lanes.
HWY_INLINE void runAffineSteps(const ProgramStep* steps, std::size_t lanes) {
    constexpr std::size_t block = affineVectors * vectorLanes;
    static_assert(batchLanes % block == 0);
    for (std::size_t first = 0; first < lanes; first += block) runAffineBlock(steps, first);
}

#undef ISOSCOPE_NO_LABELS
#undef ISOSCOPE_AFFINE_LABELS
#undef ISOSCOPE_AFFINE_STEPS

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // ISOSCOPE_MANY_REGISTERS
#endif
