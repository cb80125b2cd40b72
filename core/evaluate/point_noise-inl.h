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

#include "core/evaluate/noise-inl.h"
#include "core/function/scalar_operations.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

inline void PointAlgebra::vectorNoise(std::span<const int> components,
                                      const std::array<const double*, 3>& place,
                                      const std::array<double*, 3>& targets, std::size_t lanes) {
    const LatticeCells cells(place, lanes, allVectors);
    NoiseColumns noise;
    for (std::size_t k = 0; k < components.size(); ++k) {
        cells.sample<NoiseOrder::value>(components[k], noise);
        for (std::size_t i = 0; i < lanes; i += vectorLanes) store(load(noise.value + i), targets[k] + i);
    }
}

inline void PointAlgebra::scalarOperation(const Instruction& instruction, const CrackleSettings* crackle,
                                          const std::array<const double*, 4>& operands, double* target,
                                          std::size_t lanes) {
    const double *a = operands[0], *b = operands[1], *c = operands[2], *d = operands[3];
    if (instruction.operation == Operation::noise) {
        const auto evaluate = [=](int generator, std::size_t first, std::size_t count, double* to) HWY_ATTR {
            NoiseColumns noise;
            rawNoise<NoiseOrder::value>(generator, {b + first, c + first, d + first}, count, allVectors,
                                        noise);
            for (std::size_t i = 0; i < count; i += vectorLanes) {
                const Vector zero = hn::Zero(Doubles());
                const NoiseSample raw{load(noise.value + i), zero, zero, zero};
                store(finishedNoise<NoiseOrder::value>(generator, raw).value, to + first + i);
            }
        };
        return evaluateNoise<PointAlgebra>(a, target, lanes, evaluate);
    }
    std::array<double, 4> values{};
    for (std::size_t i = 0; i < lanes; ++i) {
        for (int k = 0; k < instruction.operandCount; ++k) values[k] = operands[k][i];
        target[i] = evaluateOperation(instruction.operation,
                                      std::span(values).first(instruction.operandCount), crackle);
    }
}

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
