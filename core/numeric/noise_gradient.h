// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace isoscope {

/// A value with its three partial derivatives.
struct NoiseGradient {
    double value = 0;
    std::array<double, 3> gradient{};
};

/// noise() and its derivatives, from the differentiated formulas of docs/povray/noise.md. The value is the
/// same to the last bit. Where noise is clipped the gradient is 0; the quantisation of generator 3 is
/// ignored.
NoiseGradient noiseWithGradient(double generator, double x, double y, double z);

/// The three components of vectorNoise() and their derivatives.
std::array<NoiseGradient, 3> vectorNoiseWithGradient(double x, double y, double z);

/// latticeNoise() and gradientNoise() with their derivatives, before scaling and clipping.
NoiseGradient latticeNoiseWithGradient(double x, double y, double z);
NoiseGradient gradientNoiseWithGradient(double x, double y, double z);

}  // namespace isoscope
