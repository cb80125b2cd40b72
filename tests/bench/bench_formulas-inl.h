// SPDX-License-Identifier: GPL-3.0-or-later
// Included once per instruction set. The formulas of BenchFunction, written once for any number type with the
// usual operators and sq, sqrt, sin, cos, abs, min found by argument-dependent lookup: as graphs for the
// evaluators, and as plain C++.
#if defined(ISOSCOPE_BENCH_FORMULAS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOSCOPE_BENCH_FORMULAS_INL
#undef ISOSCOPE_BENCH_FORMULAS_INL
#else
#define ISOSCOPE_BENCH_FORMULAS_INL
#endif

#include <hwy/highway.h>

#include "tests/bench/bench_functions.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

struct SphereFormula {
    template <class T>
    HWY_INLINE T operator()(T x, T y, T z) const {
        return sq(x) + sq(y) + sq(z) - 1.0;
    }
};

struct TorusFormula {
    template <class T>
    HWY_INLINE T operator()(T x, T y, T z) const {
        return sqrt(sq(sqrt(sq(x) + sq(z)) - 0.8) + sq(y)) - 0.3;
    }
};

struct KleinFormula {
    template <class T>
    HWY_INLINE T operator()(T x, T y, T z) const {
        const T r = sq(x) + sq(y) + sq(z), y2 = y * 2.0;
        return (r + y2 - 1.0) * (sq(r - y2 - 1.0) - sq(z) * 8.0) + x * z * 16.0 * (r - y2 - 1.0);
    }
};

struct BarthFormula {
    template <class T>
    HWY_INLINE T operator()(T x, T y, T z) const {
        constexpr double p = 1.6180339887498949, p2 = p * p;
        const T x2 = sq(x), y2 = sq(y), z2 = sq(z);
        return (x2 * p2 - y2) * -4.0 * (y2 * p2 - z2) * (z2 * p2 - x2) + sq(x2 + y2 + z2 - 1.0) * (1 + 2 * p);
    }
};

struct GyroidFormula {
    template <class T>
    HWY_INLINE T operator()(T x, T y, T z) const {
        return sin(x) * cos(y) + sin(y) * cos(z) + sin(z) * cos(x);
    }
};

struct BlendFormula {
    template <class T>
    HWY_INLINE T operator()(T x, T y, T z) const {
        return (sqrt(sq(y) + sq(z)) - 0.8) * (abs(x) + abs(y) - 1.0) - 0.03;
    }
};

/// A union of 32 balls on a lattice.
struct CsgFormula {
    template <class T>
    HWY_INLINE T operator()(T x, T y, T z) const {
        T nearest = ball(x, y, z, 0);
        for (int k = 1; k < 32; ++k) nearest = min(nearest, ball(x, y, z, k));
        return nearest;
    }

    template <class T>
    static HWY_INLINE T ball(T x, T y, T z, int k) {
        const double cx = (k % 4 - 1.5) * 0.6, cy = (k / 4 % 4 - 1.5) * 0.6, cz = (k / 16 - 0.5) * 0.6;
        return sqrt(sq(x - cx) + sq(y - cy) + sq(z - cz)) - 0.22;
    }
};

/// visit(formula) with the formula of a function.
template <class Visit>
void visitFormula(bench::BenchFunction function, Visit visit) {
    switch (function) {
        case bench::BenchFunction::sphere: return visit(SphereFormula());
        case bench::BenchFunction::torus: return visit(TorusFormula());
        case bench::BenchFunction::klein: return visit(KleinFormula());
        case bench::BenchFunction::barth: return visit(BarthFormula());
        case bench::BenchFunction::gyroid: return visit(GyroidFormula());
        case bench::BenchFunction::blend: return visit(BlendFormula());
        case bench::BenchFunction::csg: return visit(CsgFormula());
    }
}

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
