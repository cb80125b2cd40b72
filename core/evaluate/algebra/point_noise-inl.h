// SPDX-License-Identifier: GPL-3.0-or-later
// Included once per instruction set. Noise and crackle of the point evaluator.
#if defined(ISOSCOPE_EVALUATE_POINT_NOISE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOSCOPE_EVALUATE_POINT_NOISE_INL
#undef ISOSCOPE_EVALUATE_POINT_NOISE_INL
#else
#define ISOSCOPE_EVALUATE_POINT_NOISE_INL
#endif

#include <hwy/highway.h>

#include <array>

#include "core/evaluate/algebra/noise-inl.h"
#include "core/function/scalar_operations.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

inline void PointAlgebra::vectorNoise(std::span<const int> wanted, const std::array<const double*, 3>& place,
                                      const std::array<double*, 3>& targets, std::size_t lanes) {
    const LatticeCells cells(place, lanes, allVectors);
    NoiseColumns noise;
    for (std::size_t k = 0; k < wanted.size(); ++k) {
        cells.sample<NoiseOrder::value>(wanted[k], noise);
        for (std::size_t i = 0; i < lanes; i += vectorLanes) store(load(noise.value + i), targets[k] + i);
    }
}

inline void PointAlgebra::noise(int generator, const std::array<const double*, 3>& place, std::size_t lanes,
                                double* target) {
    NoiseColumns noise;
    rawNoise<NoiseOrder::value>(generator, place, lanes, allVectors, noise);
    for (std::size_t i = 0; i < lanes; i += vectorLanes) {
        const Vector zero = hn::Zero(Doubles());
        const NoiseSample raw{load(noise.value + i), zero, zero, zero};
        store(finishedNoise<NoiseOrder::value>(generator, raw).value, target + i);
    }
}

inline void PointAlgebra::scalarOperation(const Instruction& instruction, const CrackleSettings* crackle,
                                          const std::array<const double*, 4>& operands, double* target,
                                          std::size_t lanes) {
    if (instruction.operation == Operation::noise) {
        return evaluateNoise<PointAlgebra>(operands[0], {operands[1], operands[2], operands[3]}, lanes,
                                           target);
    }
    std::array<double, 4> values{};
    for (std::size_t i = 0; i < lanes; ++i) {
        for (std::size_t k = 0; k < instruction.operandCount; ++k) values[k] = operands[k][i];
        target[i] = evaluateOperation(instruction.operation,
                                      std::span(values).first(instruction.operandCount), crackle);
    }
}

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
