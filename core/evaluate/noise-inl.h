// SPDX-License-Identifier: GPL-3.0-or-later
// Included once per instruction set. noise() and vectorNoise() for vectors of points, bit for bit.
#if defined(ISOSCOPE_EVALUATE_NOISE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOSCOPE_EVALUATE_NOISE_INL
#undef ISOSCOPE_EVALUATE_NOISE_INL
#else
#define ISOSCOPE_EVALUATE_NOISE_INL
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <array>

#include "core/evaluate/gradient_noise-inl.h"
#include "core/evaluate/lattice_noise-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

// Kept out of line, once per order: the operations that use them would grow beyond measure.
template <NoiseOrder order>
HWY_NOINLINE NoiseSample latticeNoiseAt(int component, Vector x, Vector y, Vector z) {
    return LatticeCells(x, y, z).sample<order>(component);
}
template <NoiseOrder order>
HWY_NOINLINE NoiseSample gradientNoiseAt(Vector x, Vector y, Vector z) {
    return GradientCells(x, y, z).sample<order>();
}

/// The noise before offset and scaling.
template <NoiseOrder order>
HWY_INLINE NoiseSample rawNoiseAt(int generator, Vector x, Vector y, Vector z) {
    return generator == 3 ? gradientNoiseAt<order>(x, y, z) : latticeNoiseAt<order>(0, x, y, z);
}

/// noise() before clipping, from the raw noise.
HWY_INLINE Vector scaledNoise(int generator, Vector raw) {
    if (generator == 3)
        return hn::Mul(constantVector(0.5),
                       hn::Add(hn::Mul(constantVector(1.59), raw), constantVector(0.985)));
    if (generator == 2) return hn::Mul(hn::Add(raw, constantVector(1.05242)), constantVector(0.48985582));
    return hn::Add(raw, constantVector(0.5));
}

/// What scaledNoise() multiplies by.
constexpr double noiseScale(int generator) {
    return generator == 3 ? 0.5 * 1.59 : generator == 2 ? 0.48985582 : 1;
}

/// noise() of a generator 0 to 3; the derivatives are 0 where it is clipped.
template <NoiseOrder order>
HWY_INLINE NoiseSample noiseAt(int generator, Vector x, Vector y, Vector z) {
    const Vector zero = hn::Zero(Doubles()), one = constantVector(1);
    NoiseSample sample = rawNoiseAt<order>(generator, x, y, z);
    const Vector value = scaledNoise(generator, sample.value);
    const Mask positive = hn::Gt(value, zero), small = hn::Lt(value, one);
    sample.value = hn::IfThenElse(small, hn::IfThenElseZero(positive, value), one);
    if constexpr (order == NoiseOrder::gradient) {
        const Vector factor =
            hn::IfThenElseZero(hn::And(positive, small), constantVector(noiseScale(generator)));
        sample.x = hn::Mul(sample.x, factor);
        sample.y = hn::Mul(sample.y, factor);
        sample.z = hn::Mul(sample.z, factor);
    }
    return sample;
}

/// target = evaluate(generator, lane) for all vectors, where every lane has a generator of its own and nearly
/// always the same.
template <class Algebra, class Evaluate>
HWY_INLINE void evaluateNoise(const double* generators, double* target, std::size_t lanes,
                              Evaluate evaluate) {
    const Vector first = constantVector(*generators);
    bool same = true;
    for (std::size_t i = 0; i < lanes; i += vectorLanes)
        same = same && hn::AllTrue(Doubles(), hn::Eq(hn::LoadU(Doubles(), generators + i), first));
    if (HWY_LIKELY(same)) {
        const int number = noiseGeneratorNumber(*generators);
        for (std::size_t i = 0; i < lanes; i += vectorLanes) Algebra::store(evaluate(number, i), target + i);
        return;
    }
    HWY_ALIGN std::array<double, batchLanes> numbers;
    for (std::size_t i = 0; i < lanes; ++i) numbers[i] = noiseGeneratorNumber(generators[i]);
    for (std::size_t i = 0; i < lanes; i += vectorLanes) {
        auto result = evaluate(0, i);
        for (int number = 1; number < 4; ++number) {
            const Mask chosen =
                hn::Eq(hn::Load(Doubles(), numbers.data() + i), constantVector(static_cast<double>(number)));
            if (hn::AllFalse(Doubles(), chosen)) continue;
            result = Algebra::choose(chosen, evaluate(number, i), result);
        }
        Algebra::store(result, target + i);
    }
}

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
