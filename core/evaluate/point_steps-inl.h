// SPDX-License-Identifier: GPL-3.0-or-later
// Included once per instruction set. The machine with one accumulator that runs the steps of a PointProgram.
#if defined(ISOSCOPE_EVALUATE_POINT_STEPS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOSCOPE_EVALUATE_POINT_STEPS_INL
#undef ISOSCOPE_EVALUATE_POINT_STEPS_INL
#else
#define ISOSCOPE_EVALUATE_POINT_STEPS_INL
#endif

#include <hwy/highway.h>

#include <span>

#include "core/evaluate/point_algebra-inl.h"
#include "core/evaluate/point_program.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

/// Eight vectors, named one by one so that all of them stay in registers between steps.
struct PointAccumulator {
    static constexpr std::size_t vectors = 8;

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

/// accumulator, operand -> accumulator, by the names of PointCode.
struct PointSteps {
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

/// Runs the steps on the eight vectors from lane `first` on.
HWY_INLINE void runBlock(std::span<const PointStep> steps, std::size_t first) {
    using A = PointAlgebra;
    const Vector zero = hn::Zero(Doubles());
    PointAccumulator accumulator{zero, zero, zero, zero, zero, zero, zero, zero};
    for (const PointStep& step : steps) {
        const double* const a = step.lanesA;
        const double* const b = step.lanesB;
        const auto lanes = [=](std::size_t k) HWY_ATTR { return A::load(a + first + k * vectorLanes); };
        const auto uniform = [=](std::size_t) HWY_ATTR { return A::uniform(*a); };
        const auto square = [=](std::size_t k) HWY_ATTR { return A::square(lanes(k)); };
        const auto product = [=](std::size_t k) HWY_ATTR {
            return A::multiply(lanes(k), A::load(b + first + k * vectorLanes));
        };
        const auto scaled = [=](std::size_t k) HWY_ATTR { return A::multiply(lanes(k), A::uniform(*b)); };
        // clang-format off
#define ISOSCOPE_STEP(code, operation, operand) \
    case PointCode::code: accumulator.change([=](Vector v, std::size_t k) HWY_ATTR { return PointSteps::operation(v, operand(k)); }); break;
#define ISOSCOPE_STEPS(code) ISOSCOPE_STEP(code, code, lanes) ISOSCOPE_STEP(code##Uniform, code, uniform)
#define ISOSCOPE_SUM_STEPS(code) ISOSCOPE_STEPS(code) ISOSCOPE_STEP(code##Square, code, square) \
    ISOSCOPE_STEP(code##Product, code, product) ISOSCOPE_STEP(code##Scaled, code, scaled)
#define ISOSCOPE_OWN_STEP(code) \
    case PointCode::code: accumulator.change([](Vector v, std::size_t) HWY_ATTR { return A::code(v); }); break;
        // clang-format on
        switch (step.code) {
            ISOSCOPE_SUM_STEPS(load)
            ISOSCOPE_SUM_STEPS(add)
            ISOSCOPE_SUM_STEPS(subtract)
            ISOSCOPE_SUM_STEPS(subtractFrom)
            ISOSCOPE_STEPS(multiply)
            ISOSCOPE_STEPS(divide)
            ISOSCOPE_STEPS(divideInto)
            ISOSCOPE_STEPS(minimum)
            ISOSCOPE_STEPS(minimumFrom)
            ISOSCOPE_STEPS(maximum)
            ISOSCOPE_STEPS(maximumFrom)
            ISOSCOPE_OWN_STEP(square)
            ISOSCOPE_OWN_STEP(negate)
            ISOSCOPE_OWN_STEP(absolute)
            ISOSCOPE_OWN_STEP(squareRoot)
            case PointCode::store:
                accumulator.change([=, target = step.target](Vector v, std::size_t k) HWY_ATTR {
                    hn::StoreU(v, Doubles(), target + first + k * vectorLanes);
                    return v;
                });
                break;
        }
#undef ISOSCOPE_OWN_STEP
#undef ISOSCOPE_SUM_STEPS
#undef ISOSCOPE_STEPS
#undef ISOSCOPE_STEP
    }
}

/// Runs the steps on all batchLanes lanes.
HWY_INLINE void runSteps(std::span<const PointStep> steps) {
    constexpr std::size_t block = PointAccumulator::vectors * vectorLanes;
    static_assert(batchLanes % block == 0);
    for (std::size_t first = 0; first < batchLanes; first += block) runBlock(steps, first);
}

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
