// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/hand_written.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/bench/hand_written.cpp"
#include <hwy/foreach_target.h>

#include "core/evaluate/algebra/affine_algebra-inl.h"
#include "core/evaluate/algebra/point_noise-inl.h"
#include "tests/bench/bench_formulas-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

/// A number of an algebra with operators.
template <class Algebra>
struct Written {
    typename Algebra::Number number;

    static HWY_INLINE auto constant(double c) { return Algebra::uniform(c); }
    friend HWY_INLINE Written operator+(Written p, Written q) { return {Algebra().add(p.number, q.number)}; }
    friend HWY_INLINE Written operator-(Written p, Written q) {
        return {Algebra().subtract(p.number, q.number)};
    }
    friend HWY_INLINE Written operator*(Written p, Written q) {
        return {Algebra().multiply(p.number, q.number)};
    }
    friend HWY_INLINE Written operator+(Written p, double c) {
        return {Algebra().add(p.number, constant(c))};
    }
    friend HWY_INLINE Written operator-(Written p, double c) {
        return {Algebra().subtract(p.number, constant(c))};
    }
    friend HWY_INLINE Written operator*(Written p, double c) {
        return {Algebra().multiply(p.number, constant(c))};
    }
    friend HWY_INLINE Written sq(Written p) { return {Algebra().square(p.number)}; }
    friend HWY_INLINE Written abs(Written p) { return {Algebra().absolute(p.number)}; }
    friend HWY_INLINE Written sin(Written p) { return {Algebra().sine(p.number)}; }
    friend HWY_INLINE Written cos(Written p) { return {Algebra().cosine(p.number)}; }
    friend HWY_INLINE Written min(Written p, Written q) { return {Algebra().minimum(p.number, q.number)}; }
    friend HWY_INLINE Written sqrt(Written p) {
        if constexpr (Algebra::components == 1) {
            return {Algebra().squareRoot(p.number)};
        } else {
            // Sums of squares.
            return {squareRootOf(p.number, {zeroVector(), constantVector(unlimited)})};
        }
    }
};

void writtenPoints(bench::BenchFunction function, const double* x, const double* y, const double* z,
                   double* out) {
    using Number = Written<PointAlgebra>;
    visitFormula(function, [&](auto formula) HWY_ATTR {
        for (std::size_t i = 0; i < batchLanes; i += hn::Lanes(Doubles())) {
            const auto at = [i](const double* lanes)
                                HWY_ATTR { return Number{PointAlgebra::load(lanes + i)}; };
            PointAlgebra::store(formula(at(x), at(y), at(z)).number, out + i);
        }
    });
}

AffineNumber placed(const RayPieces& pieces, int axis, std::size_t i) {
    const Doubles d;
    const Vector direction = hn::LoadU(d, &pieces.direction[axis][i]);
    const Vector halfLength = half(hn::LoadU(d, &pieces.length[i]));
    const Vector along = hn::Mul(hn::Add(hn::LoadU(d, &pieces.start[i]), halfLength), direction);
    const Vector center = hn::Add(hn::LoadU(d, &pieces.origin[axis][i]), along);
    const Vector slope = hn::Mul(halfLength, direction);
    const Vector size = hn::Add(hn::Add(hn::Abs(center), hn::Abs(along)), hn::Abs(slope));
    return {center, slope, hn::MulAdd(size, constantVector(2.5e-16), constantVector(underflow))};
}

void writtenForms(bench::BenchFunction function, const RayPieces& pieces, double* out) {
    using Number = Written<AffineAlgebra>;
    visitFormula(function, [&](auto formula) HWY_ATTR {
        for (std::size_t i = 0; i < batchLanes; i += hn::Lanes(Doubles())) {
            const auto at = [&](int axis) HWY_ATTR { return Number{placed(pieces, axis, i)}; };
            AffineAlgebra::store(formula(at(0), at(1), at(2)).number, out + i);
        }
    });
}

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(writtenPoints);
HWY_EXPORT(writtenForms);

namespace bench {

void handWrittenPoints(BenchFunction function, const double* x, const double* y, const double* z,
                       double* out) {
    HWY_DYNAMIC_DISPATCH(writtenPoints)(function, x, y, z, out);
}

void handWrittenForms(BenchFunction function, const RayPieces& pieces, double* out) {
    HWY_DYNAMIC_DISPATCH(writtenForms)(function, pieces, out);
}

}  // namespace bench
}  // namespace isoscope
#endif
