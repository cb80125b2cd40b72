// SPDX-License-Identifier: GPL-3.0-or-later
// Included once per instruction set. The machine that runs the steps of a StepProgram on plain numbers.
#if defined(ISOSCOPE_EVALUATE_POINT_STEPS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOSCOPE_EVALUATE_POINT_STEPS_INL
#undef ISOSCOPE_EVALUATE_POINT_STEPS_INL
#else
#define ISOSCOPE_EVALUATE_POINT_STEPS_INL
#endif

#include <hwy/highway.h>

#include <iterator>
#include <type_traits>

#include "core/evaluate/algebra/point_algebra-inl.h"
#include "core/evaluate/steps/step_machine-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

/// Vectors of the accumulator.
constexpr std::size_t pointVectors = 8;
using PointNumbers = StepNumbers<Vector, pointVectors>;

/// A copy of the accumulator in registers.
struct RegisterCopy {
    PointNumbers numbers;

    HWY_INLINE explicit RegisterCopy(double*) : numbers(hn::Undefined(Doubles())) {}
    HWY_INLINE void take(const PointNumbers& accumulator) {
        numbers.combine(accumulator, [](Vector, Vector taken) ISOSCOPE_STEP_ATTR { return taken; });
    }
    template <class Combine>
    HWY_INLINE void goInto(PointNumbers& accumulator, Combine combine) const {
        accumulator.combine(numbers, combine);
    }
};

/// The same in memory of the caller.
struct MemoryCopy {
    double* memory;

    HWY_INLINE explicit MemoryCopy(double* room) : memory(room) {}
    HWY_INLINE void take(PointNumbers& accumulator) const {
        accumulator.change([to = memory](Vector number, std::size_t k) ISOSCOPE_STEP_ATTR {
            hn::Store(number, Doubles(), to + k * vectorLanes);
            return number;
        });
    }
    template <class Combine>
    HWY_INLINE void goInto(PointNumbers& accumulator, Combine combine) const {
        accumulator.change([from = memory, combine](Vector number, std::size_t k) ISOSCOPE_STEP_ATTR {
            return combine(number, hn::Load(Doubles(), from + k * vectorLanes));
        });
    }
};

/// With two copies of the accumulator, which find room in registers only where there are many.
struct PointMachine : StepMachine<PointAlgebra, pointVectors> {
    std::conditional_t<ISOSCOPE_MANY_REGISTERS, RegisterCopy, MemoryCopy> copy0, copy1;

    /// `scratch` is room for two numbers of all lanes.
    HWY_INLINE PointMachine(std::size_t firstLane, double* scratch)
        : StepMachine(firstLane), copy0(scratch), copy1(scratch + batchLanes) {}

    template <class Apply>
    HWY_INLINE void saved0(const ProgramStep&, Apply apply) {
        copy0.goInto(accumulator, apply);
    }
    template <class Apply>
    HWY_INLINE void saved1(const ProgramStep&, Apply apply) {
        copy1.goInto(accumulator, apply);
    }
};

// clang-format off
#define ISOSCOPE_OPERANDS(make, operation) \
    ISOSCOPE_MEMORY_OPERANDS(make, operation) make(operation, saved0) make(operation, saved1)
#define ISOSCOPE_POINT_OPERATIONS(make) \
    ISOSCOPE_OPERANDS(make, load) ISOSCOPE_OPERANDS(make, add) ISOSCOPE_OPERANDS(make, subtract) \
    ISOSCOPE_OPERANDS(make, subtractFrom) ISOSCOPE_OPERANDS(make, multiply) ISOSCOPE_OPERANDS(make, multiplyInto) ISOSCOPE_OPERANDS(make, divide) \
    ISOSCOPE_OPERANDS(make, divideInto) ISOSCOPE_OPERANDS(make, minimum) ISOSCOPE_OPERANDS(make, minimumFrom) \
    ISOSCOPE_OPERANDS(make, maximum) ISOSCOPE_OPERANDS(make, maximumFrom)
// clang-format on

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpedantic"  // addresses of labels: g++ and clang++ know them alike
/// Runs the steps up to an `end` on the vectors from lane `first` on. `scratch` is room for two numbers of
/// all lanes.
inline HWY_NOINLINE void runPointBlock(const ProgramStep* step, std::size_t first, double* scratch) {
    using Algebra = PointAlgebra;
    using Operations = StepOperations<Algebra>;
    // clang-format off
    static const void* const labels[] = {
        ISOSCOPE_POINT_OPERATIONS(ISOSCOPE_LABEL)
        &&square, &&negate, &&absolute, &&squareRoot, &&store, &&save0, &&save1, &&end};
    // clang-format on
    static_assert(std::size(labels) == ProgramStep::codeOf(StepOperation::end) + 1);
    PointMachine machine(first, scratch);
    goto* labels[step->code];
    ISOSCOPE_POINT_OPERATIONS(ISOSCOPE_STEP)
    ISOSCOPE_OWN_STEP(square)
    ISOSCOPE_OWN_STEP(negate)
    ISOSCOPE_OWN_STEP(absolute)
    ISOSCOPE_OWN_STEP(squareRoot)
save0:
    machine.copy0.take(machine.accumulator);
    ISOSCOPE_NEXT;
save1:
    machine.copy1.take(machine.accumulator);
    ISOSCOPE_NEXT;
store:
    // May be memory of the caller.
    machine.accumulator.change([to = step->target + first](Vector v, std::size_t k) ISOSCOPE_STEP_ATTR {
        hn::StoreU(v, Doubles(), to + k * vectorLanes);
        return v;
    });
    ISOSCOPE_NEXT;
end:
    return;
}
#pragma GCC diagnostic pop

#undef ISOSCOPE_POINT_OPERATIONS
#undef ISOSCOPE_OPERANDS

/// Runs the steps up to an `end` on all batchLanes lanes.
HWY_INLINE void runPointSteps(const ProgramStep* steps, double* scratch) {
    constexpr std::size_t block = pointVectors * vectorLanes;
    static_assert(batchLanes % block == 0);
    for (std::size_t first = 0; first < batchLanes; first += block) runPointBlock(steps, first, scratch);
}

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
