// SPDX-License-Identifier: GPL-3.0-or-later
// Included once per instruction set. Declares SLEEF's functions (error at most 1.0 ulp) for the vectors of
// the set at hand: its own header declares only those of the compiler's baseline. Without a SLEEF variant for
// the set, the standard library serves lane by lane.
#if defined(ISOSCOPE_EVALUATE_SLEEF_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOSCOPE_EVALUATE_SLEEF_INL
#undef ISOSCOPE_EVALUATE_SLEEF_INL
#else
#define ISOSCOPE_EVALUATE_SLEEF_INL
#endif

#include <hwy/highway.h>

#include <cmath>

#include "core/evaluate/sleef/sleef_functions.h"

#undef ISOSCOPE_SLEEF_NAME
#undef ISOSCOPE_SLEEF_IN_MEMORY
#if HWY_TARGET == HWY_AVX3
#define ISOSCOPE_SLEEF_NAME(function) Sleef_##function##d8_u10avx512f
#ifdef __clang__
#define ISOSCOPE_SLEEF_IN_MEMORY(function) sleef::function##InMemoryAvx512
#endif
#elif HWY_TARGET == HWY_AVX2
#define ISOSCOPE_SLEEF_NAME(function) Sleef_##function##d4_u10avx2
#ifdef __clang__
#define ISOSCOPE_SLEEF_IN_MEMORY(function) sleef::function##InMemoryAvx2
#endif
#elif HWY_TARGET == HWY_SSE4
#define ISOSCOPE_SLEEF_NAME(function) Sleef_##function##d2_u10sse4
#elif HWY_TARGET == HWY_NEON
#define ISOSCOPE_SLEEF_NAME(function) Sleef_##function##d2_u10advsimd
#endif

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Doubles = hn::ScalableTag<double>;
using Vector = hn::Vec<Doubles>;

/// Calls `function` for every lane.
template <class Scalar>
HWY_INLINE Vector laneByLane(Scalar function, Vector a) {
    const Doubles d;
    HWY_ALIGN double lanes[HWY_MAX_BYTES / sizeof(double)];
    hn::Store(a, d, lanes);
    for (std::size_t i = 0; i < hn::Lanes(d); ++i) lanes[i] = function(lanes[i]);
    return hn::Load(d, lanes);
}

template <class Scalar>
HWY_INLINE Vector laneByLane(Scalar function, Vector a, Vector b) {
    const Doubles d;
    HWY_ALIGN double first[HWY_MAX_BYTES / sizeof(double)];
    HWY_ALIGN double second[HWY_MAX_BYTES / sizeof(double)];
    hn::Store(a, d, first);
    hn::Store(b, d, second);
    for (std::size_t i = 0; i < hn::Lanes(d); ++i) first[i] = function(first[i], second[i]);
    return hn::Load(d, first);
}

#ifdef ISOSCOPE_SLEEF_IN_MEMORY
#define ISOSCOPE_SLEEF_1(name, function)                        \
    HWY_INLINE Vector name(Vector a) {                          \
        const Doubles d;                                        \
        HWY_ALIGN double lanes[HWY_MAX_BYTES / sizeof(double)]; \
        hn::Store(a, d, lanes);                                 \
        ISOSCOPE_SLEEF_IN_MEMORY(function)(lanes, lanes);       \
        return hn::Load(d, lanes);                              \
    }
#define ISOSCOPE_SLEEF_2(name, function)                          \
    HWY_INLINE Vector name(Vector a, Vector b) {                  \
        const Doubles d;                                          \
        HWY_ALIGN double first[HWY_MAX_BYTES / sizeof(double)];   \
        HWY_ALIGN double second[HWY_MAX_BYTES / sizeof(double)];  \
        hn::Store(a, d, first);                                   \
        hn::Store(b, d, second);                                  \
        ISOSCOPE_SLEEF_IN_MEMORY(function)(first, second, first); \
        return hn::Load(d, first);                                \
    }
#elif defined(ISOSCOPE_SLEEF_NAME)
using RawVector = decltype(Vector::raw);
#define ISOSCOPE_SLEEF_1(name, function)                           \
    extern "C" RawVector ISOSCOPE_SLEEF_NAME(function)(RawVector); \
    HWY_INLINE Vector name(Vector a) { return Vector{ISOSCOPE_SLEEF_NAME(function)(a.raw)}; }
#define ISOSCOPE_SLEEF_2(name, function)                                      \
    extern "C" RawVector ISOSCOPE_SLEEF_NAME(function)(RawVector, RawVector); \
    HWY_INLINE Vector name(Vector a, Vector b) { return Vector{ISOSCOPE_SLEEF_NAME(function)(a.raw, b.raw)}; }
#else
#define ISOSCOPE_SLEEF_1(name, function)                                 \
    HWY_INLINE Vector name(Vector a) {                                   \
        return laneByLane([](double x) { return std::function(x); }, a); \
    }
#define ISOSCOPE_SLEEF_2(name, function)                                                 \
    HWY_INLINE Vector name(Vector a, Vector b) {                                         \
        return laneByLane([](double x, double y) { return std::function(x, y); }, a, b); \
    }
#endif

ISOSCOPE_SLEEF_1(sleefSin, sin)
ISOSCOPE_SLEEF_1(sleefCos, cos)
ISOSCOPE_SLEEF_1(sleefTan, tan)
ISOSCOPE_SLEEF_1(sleefAsin, asin)
ISOSCOPE_SLEEF_1(sleefAcos, acos)
ISOSCOPE_SLEEF_1(sleefAtan, atan)
ISOSCOPE_SLEEF_1(sleefExp, exp)
ISOSCOPE_SLEEF_1(sleefLog, log)
ISOSCOPE_SLEEF_1(sleefLog10, log10)
ISOSCOPE_SLEEF_1(sleefSinh, sinh)
ISOSCOPE_SLEEF_1(sleefCosh, cosh)
ISOSCOPE_SLEEF_1(sleefTanh, tanh)
ISOSCOPE_SLEEF_1(sleefAsinh, asinh)
ISOSCOPE_SLEEF_1(sleefAcosh, acosh)
ISOSCOPE_SLEEF_1(sleefAtanh, atanh)
ISOSCOPE_SLEEF_2(sleefPow, pow)
ISOSCOPE_SLEEF_2(sleefAtan2, atan2)

#undef ISOSCOPE_SLEEF_1
#undef ISOSCOPE_SLEEF_2

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
