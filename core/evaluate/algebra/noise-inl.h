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
#include <type_traits>

#include "core/evaluate/algebra/gradient_noise-inl.h"
#include "core/evaluate/algebra/lattice_noise-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

/// Bits of LatticeCells for all vectors.
constexpr std::uint64_t allVectors = ~std::uint64_t{0};

// Kept out of line, once per order: the operations that use them would grow beyond measure. Of `lanes`
// points, whole vectors; only of the vectors whose bits are set in `wanted`.
template <NoiseOrder order>
HWY_NOINLINE void latticeNoise(int component, const std::array<const double*, 3>& point, std::size_t lanes,
                               std::uint64_t wanted, NoiseColumns& noise) {
    LatticeCells(point, lanes, wanted).sample<order>(component, noise);
}
inline HWY_NOINLINE void latticeNoiseAlong(int component, const std::array<const double*, 3>& point,
                                           const NoiseWays& ways, std::size_t lanes, std::uint64_t wanted,
                                           NoiseLines& lines) {
    LatticeCells(point, lanes, wanted).sampleAlong(component, ways, lines);
}
template <NoiseOrder order>
HWY_NOINLINE void gradientNoise(const std::array<const double*, 3>& point, std::size_t lanes,
                                std::uint64_t wanted, NoiseColumns& noise) {
    const Doubles d;
    for (std::size_t i = 0; i < lanes; i += vectorLanes) {
        if (((wanted >> (i / vectorLanes)) & 1u) == 0) continue;
        const GradientCells cells(hn::LoadU(d, point[0] + i), hn::LoadU(d, point[1] + i),
                                  hn::LoadU(d, point[2] + i));
        noise.store<order>(cells.sample<order>(), i);
    }
}

/// The noise before offset and scaling. Lattice noise needs no column for a y of 0.
template <NoiseOrder order>
HWY_INLINE void rawNoise(int generator, const std::array<const double*, 3>& point, std::size_t lanes,
                         std::uint64_t wanted, NoiseColumns& noise) {
    if (generator == 3)
        gradientNoise<order>(point, lanes, wanted, noise);
    else
        latticeNoise<order>(0, point, lanes, wanted, noise);
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

/// noise() of a generator 0 to 3 from its raw noise; the derivatives are 0 where it is clipped.
template <NoiseOrder order>
HWY_INLINE NoiseSample finishedNoise(int generator, NoiseSample sample) {
    const Vector zero = hn::Zero(Doubles()), one = constantVector(1);
    const Vector value = scaledNoise(generator, sample.value);
    const Mask positive = hn::Gt(value, zero), small = hn::Lt(value, one);
    sample.value = hn::IfThenElse(small, hn::IfThenElseZero(positive, value), one);
    if constexpr (order != NoiseOrder::value) {
        const Vector factor =
            hn::IfThenElseZero(hn::And(positive, small), constantVector(noiseScale(generator)));
        sample.x = hn::Mul(sample.x, factor);
        if constexpr (order == NoiseOrder::gradient) sample.y = hn::Mul(sample.y, factor);
        sample.z = hn::Mul(sample.z, factor);
    }
    return sample;
}

/// Calls run(generator, ground) with both of them as constants of the compiler; generators 0 and 1 are alike.
/// With `ground`, which generator 3 does not know, y is 0 and has no lanes.
template <class Run>
HWY_INLINE void withNoiseKind(int generator, bool ground, Run run) {
    const std::integral_constant<int, 0> plain;
    const std::integral_constant<int, 2> scaled;
    if (generator == 3)
        run(std::integral_constant<int, 3>(), std::false_type());
    else if (generator == 2)
        ground ? run(scaled, std::true_type()) : run(scaled, std::false_type());
    else
        ground ? run(plain, std::true_type()) : run(plain, std::false_type());
}

/// Puts the noise of all lanes into target by Algebra::noise(), where every lane has a generator of its own
/// and nearly always the same.
template <class Algebra>
HWY_INLINE void evaluateNoise(const double* generators, const std::array<const double*, 3>& place,
                              std::size_t lanes, double* target) {
    const auto evaluate = [&](int generator, std::size_t first, std::size_t count, double* to) HWY_ATTR {
        Algebra::noise(generator, {place[0] + first, place[1] + first, place[2] + first}, count, to + first);
    };
    const Vector first = constantVector(*generators);
    bool same = true;
    for (std::size_t i = 0; i < lanes; i += vectorLanes)
        same = same && hn::AllTrue(Doubles(), hn::Eq(hn::LoadU(Doubles(), generators + i), first));
    if (HWY_LIKELY(same)) {
        evaluate(noiseGeneratorNumber(*generators), std::size_t{0}, lanes, target);
        return;
    }
    HWY_ALIGN std::array<double, batchLanes> numbers;
    for (std::size_t i = 0; i < lanes; ++i) numbers[i] = noiseGeneratorNumber(generators[i]);
    HWY_ALIGN std::array<double, Algebra::components * batchLanes> room;
    for (std::size_t i = 0; i < lanes; i += vectorLanes) {
        evaluate(0, i, vectorLanes, room.data());
        auto result = Algebra::load(room.data() + i);
        for (int number = 1; number < 4; ++number) {
            const Mask chosen =
                hn::Eq(hn::Load(Doubles(), numbers.data() + i), constantVector(static_cast<double>(number)));
            if (hn::AllFalse(Doubles(), chosen)) continue;
            evaluate(number, i, vectorLanes, room.data());
            result = Algebra::choose(chosen, Algebra::load(room.data() + i), result);
        }
        Algebra::store(result, target + i);
    }
}

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
