// SPDX-License-Identifier: GPL-3.0-or-later
// Included once per instruction set. What the machines that run the steps of a StepProgram have in common.
#if defined(ISOSCOPE_EVALUATE_STEP_MACHINE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOSCOPE_EVALUATE_STEP_MACHINE_INL
#undef ISOSCOPE_EVALUATE_STEP_MACHINE_INL
#else
#define ISOSCOPE_EVALUATE_STEP_MACHINE_INL
#endif

#include <hwy/highway.h>

#include "core/evaluate/algebra/noise_sample-inl.h"
#include "core/evaluate/algebra/point_algebra-inl.h"
#include "core/evaluate/steps/step_program.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

// For lambdas, which the compiler calls where it should inline them.
#undef ISOSCOPE_STEP_ATTR
#define ISOSCOPE_STEP_ATTR HWY_ATTR __attribute__((always_inline))

/// Whether there are 32 vector registers, not 16.
#undef ISOSCOPE_MANY_REGISTERS
#define ISOSCOPE_MANY_REGISTERS \
    (HWY_ARCH_X86_64 ? HWY_TARGET != HWY_SCALAR && HWY_TARGET <= HWY_AVX3 : HWY_TARGET == HWY_NEON)

/// Vectors of numbers, each a member of its own, so that all of them stay in registers between steps.
template <class Number, std::size_t count>
struct StepNumbers {
    Number head;
    StepNumbers<Number, count - 1> tail;

    HWY_INLINE explicit StepNumbers(const Number& value) : head(value), tail(value) {}

    /// Every vector becomes change(vector, its place).
    template <std::size_t place = 0, class Change>
    HWY_INLINE void change(Change change) {
        head = change(head, place);
        tail.template change<place + 1>(change);
    }
    /// Every vector becomes combine(vector, the one at its place in `others`).
    template <class Combine>
    HWY_INLINE void combine(const StepNumbers& others, Combine combine) {
        head = combine(head, others.head);
        tail.combine(others.tail, combine);
    }
};
template <class Number>
struct StepNumbers<Number, 0> {
    HWY_INLINE explicit StepNumbers(const Number&) {}
    template <std::size_t place, class Change>
    HWY_INLINE void change(Change) {}
    template <class Combine>
    HWY_INLINE void combine(const StepNumbers&, Combine) {}
};

/// An accumulator of `count` vectors, and what steps do with an operand: the functions have the names of
/// StepOperand; apply(accumulator, operand) is what becomes of the accumulator.
template <class Algebra, std::size_t count>
struct StepMachine {
    using Number = typename Algebra::Number;
    using Uniform = typename Algebra::Uniform;

    StepNumbers<Number, count> accumulator;
    std::size_t first;  ///< lane of the first vector

    HWY_INLINE explicit StepMachine(std::size_t firstLane) : accumulator(anything()), first(firstLane) {}

    /// No step reads it.
    static HWY_INLINE Number anything() {
        const Vector vector = hn::Undefined(Doubles());
        if constexpr (Algebra::components == 1)
            return vector;
        else if constexpr (Algebra::components == 3)
            return {vector, vector, vector};
        else if constexpr (Algebra::components == 4)
            return {vector, vector, vector, vector};
        else
            return {{vector, vector, vector, vector}, vector, vector, vector};
    }

    template <class Apply>
    HWY_INLINE void lanes(const ProgramStep& step, Apply apply) {
        const double* const a = step.lanesA + first;
        accumulator.change([=](const Number& v, std::size_t k)
                               ISOSCOPE_STEP_ATTR { return apply(v, Algebra::load(a + k * vectorLanes)); });
    }
    template <class Apply>
    HWY_INLINE void square(const ProgramStep& step, Apply apply) {
        const double* const a = step.lanesA + first;
        accumulator.change([=](const Number& v, std::size_t k) ISOSCOPE_STEP_ATTR {
            return apply(v, Algebra().square(Algebra::load(a + k * vectorLanes)));
        });
    }
    template <class Apply>
    HWY_INLINE void product(const ProgramStep& step, Apply apply) {
        const double* const a = step.lanesA + first;
        const double* const b = step.lanesB + first;
        accumulator.change([=](const Number& v, std::size_t k) ISOSCOPE_STEP_ATTR {
            return apply(v, Algebra().multiply(Algebra::load(a + k * vectorLanes),
                                               Algebra::load(b + k * vectorLanes)));
        });
    }
    template <class Apply>
    HWY_INLINE void scaled(const ProgramStep& step, Apply apply) {
        const double* const a = step.lanesA + first;
        const Uniform u = Algebra::uniform(*step.lanesB);
        accumulator.change([=](const Number& v, std::size_t k) ISOSCOPE_STEP_ATTR {
            return apply(v, Algebra().multiply(Algebra::load(a + k * vectorLanes), u));
        });
    }
    template <class Apply>
    HWY_INLINE void scaledSquare(const ProgramStep& step, Apply apply) {
        const double* const a = step.lanesA + first;
        const Uniform u = Algebra::uniform(*step.lanesB);
        accumulator.change([=](const Number& v, std::size_t k) ISOSCOPE_STEP_ATTR {
            return apply(v, Algebra().multiply(Algebra().square(Algebra::load(a + k * vectorLanes)), u));
        });
    }
    template <class Apply>
    HWY_INLINE void uniform(const ProgramStep& step, Apply apply) {
        const Uniform u = Algebra::uniform(*step.lanesA);
        accumulator.change([=](const Number& v, std::size_t) ISOSCOPE_STEP_ATTR { return apply(v, u); });
    }
};

/// accumulator, operand -> accumulator, by the names of StepOperation.
template <class Algebra>
struct StepOperations {
    using Number = typename Algebra::Number;
    static HWY_INLINE Number load(const Number&, const Number& a) { return a; }
    template <class Operand>
    static HWY_INLINE Number add(const Number& v, const Operand& a) {
        return Algebra().add(v, a);
    }
    template <class Operand>
    static HWY_INLINE Number subtract(const Number& v, const Operand& a) {
        return Algebra().subtract(v, a);
    }
    template <class Operand>
    static HWY_INLINE Number subtractFrom(const Number& v, const Operand& a) {
        return Algebra().subtract(a, v);
    }
    template <class Operand>
    static HWY_INLINE Number multiply(const Number& v, const Operand& a) {
        return Algebra().multiply(v, a);
    }
    template <class Operand>
    static HWY_INLINE Number multiplyInto(const Number& v, const Operand& a) {
        return Algebra().multiply(a, v);
    }
    static HWY_INLINE Number divide(const Number& v, const Number& a) { return Algebra().divide(v, a); }
    static HWY_INLINE Number divideInto(const Number& v, const Number& a) { return Algebra().divide(a, v); }
    template <class Operand>
    static HWY_INLINE Number minimum(const Number& v, const Operand& a) {
        return Algebra().minimum(v, a);
    }
    template <class Operand>
    static HWY_INLINE Number minimumFrom(const Number& v, const Operand& a) {
        return Algebra().minimum(a, v);
    }
    template <class Operand>
    static HWY_INLINE Number maximum(const Number& v, const Operand& a) {
        return Algebra().maximum(v, a);
    }
    template <class Operand>
    static HWY_INLINE Number maximumFrom(const Number& v, const Operand& a) {
        return Algebra().maximum(a, v);
    }
};

// Every step jumps to the next one itself: with one jump for all of them, finding the next step takes longer
// than the step. A function with such jumps has a machine, a table of labels in the order of
// ProgramStep::codeOf(), and these behind the labels.
// clang-format off
#undef ISOSCOPE_MEMORY_OPERANDS
#define ISOSCOPE_MEMORY_OPERANDS(make, operation) \
    make(operation, lanes) make(operation, square) make(operation, product) make(operation, scaled) \
    make(operation, scaledSquare) make(operation, uniform)
#undef ISOSCOPE_LABEL
#define ISOSCOPE_LABEL(operation, operand) &&operation##_##operand,
#undef ISOSCOPE_NEXT
#define ISOSCOPE_NEXT goto *labels[(++step)->code]
#undef ISOSCOPE_STEP
#define ISOSCOPE_STEP(operation, operand) \
    operation##_##operand: \
        machine.operand(*step, [](const auto& v, const auto& a) ISOSCOPE_STEP_ATTR { return Operations::operation(v, a); }); \
        ISOSCOPE_NEXT;
#undef ISOSCOPE_OWN_STEP
#define ISOSCOPE_OWN_STEP(operation) \
    operation: \
        machine.accumulator.change([](const auto& v, std::size_t) ISOSCOPE_STEP_ATTR { return Algebra().operation(v); }); \
        ISOSCOPE_NEXT;
// clang-format on

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
