// SPDX-License-Identifier: GPL-3.0-or-later
// Included once per instruction set. The machine with one accumulator that runs the steps of a PointProgram.
#if defined(ISOSCOPE_EVALUATE_POINT_STEPS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOSCOPE_EVALUATE_POINT_STEPS_INL
#undef ISOSCOPE_EVALUATE_POINT_STEPS_INL
#else
#define ISOSCOPE_EVALUATE_POINT_STEPS_INL
#endif

#include <hwy/highway.h>

#include <iterator>
#include <type_traits>

#include "core/evaluate/point_algebra-inl.h"
#include "core/evaluate/point_program.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

/// Eight vectors, named one by one so that all of them stay in registers between steps.
struct PointVectors {
    static constexpr std::size_t count = 8;

    Vector v0, v1, v2, v3, v4, v5, v6, v7;

    /// Every vector becomes change(vector, number of the vector).
    template <class Change>
    HWY_INLINE void change(Change change) {
        v0 = change(v0, 0);
        v1 = change(v1, 1);
        v2 = change(v2, 2);
        v3 = change(v3, 3);
        v4 = change(v4, 4);
        v5 = change(v5, 5);
        v6 = change(v6, 6);
        v7 = change(v7, 7);
    }
};

/// A copy of the accumulator in registers.
struct RegisterCopy {
    PointVectors vectors;

    HWY_INLINE explicit RegisterCopy(double*) {
        const Vector zero = hn::Zero(Doubles());
        vectors = {zero, zero, zero, zero, zero, zero, zero, zero};
    }
    HWY_INLINE void take(const PointVectors& accumulator) {
        vectors.v0 = accumulator.v0;
        vectors.v1 = accumulator.v1;
        vectors.v2 = accumulator.v2;
        vectors.v3 = accumulator.v3;
        vectors.v4 = accumulator.v4;
        vectors.v5 = accumulator.v5;
        vectors.v6 = accumulator.v6;
        vectors.v7 = accumulator.v7;
    }
    template <class Combine>
    HWY_INLINE void goInto(PointVectors& accumulator, Combine combine) const {
        accumulator.v0 = combine(accumulator.v0, vectors.v0);
        accumulator.v1 = combine(accumulator.v1, vectors.v1);
        accumulator.v2 = combine(accumulator.v2, vectors.v2);
        accumulator.v3 = combine(accumulator.v3, vectors.v3);
        accumulator.v4 = combine(accumulator.v4, vectors.v4);
        accumulator.v5 = combine(accumulator.v5, vectors.v5);
        accumulator.v6 = combine(accumulator.v6, vectors.v6);
        accumulator.v7 = combine(accumulator.v7, vectors.v7);
    }
};

/// The same in memory of the caller.
struct MemoryCopy {
    double* lanes;

    HWY_INLINE explicit MemoryCopy(double* memory) : lanes(memory) {}
    HWY_INLINE void take(PointVectors accumulator) const {
        accumulator.change([to = lanes](Vector v, std::size_t k) HWY_ATTR {
            hn::Store(v, Doubles(), to + k * vectorLanes);
            return v;
        });
    }
    template <class Combine>
    HWY_INLINE void goInto(PointVectors& accumulator, Combine combine) const {
        accumulator.change([from = lanes, combine](Vector v, std::size_t k)
                               HWY_ATTR { return combine(v, hn::Load(Doubles(), from + k * vectorLanes)); });
    }
};

/// Only with 32 registers do the copies find room beside the accumulator.
constexpr bool hasManyRegisters =
    HWY_ARCH_X86_64 ? HWY_TARGET != HWY_SCALAR && HWY_TARGET <= HWY_AVX3 : HWY_TARGET == HWY_NEON;
using PointCopy = std::conditional_t<hasManyRegisters, RegisterCopy, MemoryCopy>;

struct PointMachine {
    PointVectors accumulator;
    PointCopy copy0, copy1;
    std::size_t first;  ///< lane of the first vector
};

/// accumulator, operand -> accumulator, by the names of PointOperation.
struct PointOperations {
    using A = PointAlgebra;
    static HWY_INLINE Vector load(Vector, Vector a) { return a; }
    static HWY_INLINE Vector add(Vector v, Vector a) { return A::add(v, a); }
    static HWY_INLINE Vector subtract(Vector v, Vector a) { return A::subtract(v, a); }
    static HWY_INLINE Vector subtractFrom(Vector v, Vector a) { return A::subtract(a, v); }
    static HWY_INLINE Vector multiply(Vector v, Vector a) { return A::multiply(v, a); }
    static HWY_INLINE Vector divide(Vector v, Vector a) { return A::divide(v, a); }
    static HWY_INLINE Vector divideInto(Vector v, Vector a) { return A::divide(a, v); }
    static HWY_INLINE Vector minimum(Vector v, Vector a) { return A::minimum(v, a); }
    static HWY_INLINE Vector minimumFrom(Vector v, Vector a) { return A::minimum(a, v); }
    static HWY_INLINE Vector maximum(Vector v, Vector a) { return A::maximum(v, a); }
    static HWY_INLINE Vector maximumFrom(Vector v, Vector a) { return A::maximum(a, v); }
};

/// Apply an operation to the accumulator and an operand, by the names of PointOperand.
struct PointOperands {
    using A = PointAlgebra;
    using M = PointMachine;

    template <class Apply, class Operand>
    static HWY_INLINE void change(M& m, Apply apply, Operand operand) {
        m.accumulator.change([=](Vector v, std::size_t k) HWY_ATTR { return apply(v, operand(k)); });
    }
    template <class Apply>
    static HWY_INLINE void lanes(M& m, const PointStep& step, Apply apply) {
        const double* const a = step.lanesA + m.first;
        change(m, apply, [=](std::size_t k) HWY_ATTR { return A::load(a + k * vectorLanes); });
    }
    template <class Apply>
    static HWY_INLINE void square(M& m, const PointStep& step, Apply apply) {
        const double* const a = step.lanesA + m.first;
        change(m, apply, [=](std::size_t k) HWY_ATTR { return A::square(A::load(a + k * vectorLanes)); });
    }
    template <class Apply>
    static HWY_INLINE void product(M& m, const PointStep& step, Apply apply) {
        const double* const a = step.lanesA + m.first;
        const double* const b = step.lanesB + m.first;
        change(m, apply, [=](std::size_t k) HWY_ATTR {
            return A::multiply(A::load(a + k * vectorLanes), A::load(b + k * vectorLanes));
        });
    }
    template <class Apply>
    static HWY_INLINE void scaled(M& m, const PointStep& step, Apply apply) {
        const double* const a = step.lanesA + m.first;
        const Vector u = A::uniform(*step.lanesB);
        change(m, apply,
               [=](std::size_t k) HWY_ATTR { return A::multiply(A::load(a + k * vectorLanes), u); });
    }
    template <class Apply>
    static HWY_INLINE void scaledSquare(M& m, const PointStep& step, Apply apply) {
        const double* const a = step.lanesA + m.first;
        const Vector u = A::uniform(*step.lanesB);
        change(m, apply, [=](std::size_t k) HWY_ATTR {
            return A::multiply(A::square(A::load(a + k * vectorLanes)), u);
        });
    }
    template <class Apply>
    static HWY_INLINE void uniform(M& m, const PointStep& step, Apply apply) {
        const Vector u = A::uniform(*step.lanesA);
        change(m, apply, [=](std::size_t) HWY_ATTR { return u; });
    }
    template <class Apply>
    static HWY_INLINE void saved0(M& m, const PointStep&, Apply apply) {
        m.copy0.goInto(m.accumulator, apply);
    }
    template <class Apply>
    static HWY_INLINE void saved1(M& m, const PointStep&, Apply apply) {
        m.copy1.goInto(m.accumulator, apply);
    }
};

// clang-format off
#define ISOSCOPE_OPERANDS(make, operation) \
    make(operation, lanes) make(operation, square) make(operation, product) make(operation, scaled) \
    make(operation, scaledSquare) make(operation, uniform) make(operation, saved0) make(operation, saved1)
#define ISOSCOPE_OPERATIONS(make) \
    ISOSCOPE_OPERANDS(make, load) ISOSCOPE_OPERANDS(make, add) ISOSCOPE_OPERANDS(make, subtract) \
    ISOSCOPE_OPERANDS(make, subtractFrom) ISOSCOPE_OPERANDS(make, multiply) ISOSCOPE_OPERANDS(make, divide) \
    ISOSCOPE_OPERANDS(make, divideInto) ISOSCOPE_OPERANDS(make, minimum) ISOSCOPE_OPERANDS(make, minimumFrom) \
    ISOSCOPE_OPERANDS(make, maximum) ISOSCOPE_OPERANDS(make, maximumFrom)
#define ISOSCOPE_LABEL(operation, operand) &&operation##_##operand,
#define ISOSCOPE_NEXT goto *labels[(++step)->code]
#define ISOSCOPE_STEP(operation, operand) \
    operation##_##operand: \
        PointOperands::operand(machine, *step, [](Vector v, Vector a) HWY_ATTR { return PointOperations::operation(v, a); }); \
        ISOSCOPE_NEXT;
#define ISOSCOPE_OWN_STEP(operation) \
    operation: \
        machine.accumulator.change([](Vector v, std::size_t) HWY_ATTR { return PointAlgebra::operation(v); }); \
        ISOSCOPE_NEXT;
// clang-format on

/// Runs the steps up to an `end` on the eight vectors from lane `first` on. Every step jumps to the next one
/// itself: with one jump for all of them, finding the next step takes longer than a step. `scratch` is room
/// for two numbers of all lanes.
HWY_NOINLINE void runBlock(const PointStep* step, std::size_t first, double* scratch) {
    // clang-format off
    // In the order of PointStep::codeOf().
    static const void* const labels[] = {
        ISOSCOPE_OPERATIONS(ISOSCOPE_LABEL)
        &&square, &&negate, &&absolute, &&squareRoot, &&store, &&save0, &&save1, &&end};
    // clang-format on
    static_assert(std::size(labels) == PointStep::codeOf(PointOperation::end) + 1);
    const Vector zero = hn::Zero(Doubles());
    PointMachine machine{{zero, zero, zero, zero, zero, zero, zero, zero},
                         PointCopy(scratch),
                         PointCopy(scratch + batchLanes),
                         first};
    goto* labels[step->code];
    ISOSCOPE_OPERATIONS(ISOSCOPE_STEP)
    ISOSCOPE_OWN_STEP(square)
    ISOSCOPE_OWN_STEP(negate)
    ISOSCOPE_OWN_STEP(absolute)
    ISOSCOPE_OWN_STEP(squareRoot)
store:
    machine.accumulator.change([to = step->target + first](Vector v, std::size_t k) HWY_ATTR {
        hn::StoreU(v, Doubles(), to + k * vectorLanes);
        return v;
    });
    ISOSCOPE_NEXT;
save0:
    machine.copy0.take(machine.accumulator);
    ISOSCOPE_NEXT;
save1:
    machine.copy1.take(machine.accumulator);
    ISOSCOPE_NEXT;
end:
    return;
}

#undef ISOSCOPE_OWN_STEP
#undef ISOSCOPE_STEP
#undef ISOSCOPE_NEXT
#undef ISOSCOPE_LABEL
#undef ISOSCOPE_OPERATIONS
#undef ISOSCOPE_OPERANDS

/// Runs the steps up to an `end` on all batchLanes lanes.
HWY_INLINE void runSteps(const PointStep* steps, double* scratch) {
    constexpr std::size_t block = PointVectors::count * vectorLanes;
    static_assert(batchLanes % block == 0);
    for (std::size_t first = 0; first < batchLanes; first += block) runBlock(steps, first, scratch);
}

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
