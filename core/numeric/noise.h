// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace isoscope {

/// POV-Ray's noise, bit for bit (docs/povray/noise.md, sections 2 to 6). All functions are pure and thread
/// safe. Coordinates that are not finite, or not below 2^31 in magnitude, act as 0: the result has no
/// meaning, but it is finite and the same for every evaluator.

/// Noise of generator 0 to 3, in [0, 1]. Other numbers act as in section 6: truncated, then modulo 4.
double noise(double generator, double x, double y, double z);

/// The generator that a number stands for, 0 to 3; what does not fit 32 bits (NaN too) is 0.
int noiseGeneratorNumber(double generator);

/// L_0 of section 4, the sum over the eight lattice corners before offset and clipping.
double latticeNoise(double x, double y, double z);

/// K of section 5, gradient noise before scaling and clipping.
double gradientNoise(double x, double y, double z);

/// The vector noise DNoise = (L_0, L_1, L_2), the same for every generator.
std::array<double, 3> vectorNoise(double x, double y, double z);

/// The lattice hash table H: 8192 entries, a permutation of 0..4095 twice.
const std::array<unsigned short, 8192>& latticeHash();

/// The value table V of the lattice noise (267 entries).
const std::array<double, 267>& latticeValues();

/// Tables of gradient noise (generator 3): 2048 unit gradients and the 4098 hash entries Q.
struct GradientNoiseTables {
    std::array<std::array<double, 3>, 2048> gradients;
    std::array<unsigned short, 4098> hash;
};
/// Made at the first call, of any thread; the same object ever after.
const GradientNoiseTables& gradientNoiseTables();

}  // namespace isoscope
