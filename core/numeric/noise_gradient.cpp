// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numeric/noise_gradient.h"

#include "core/numeric/noise.h"
#include "core/numeric/noise_place.h"

namespace isoscope {

namespace {

/// The sums of latticeSums with their derivatives; the values are formed in the same order.
template <int Count>
std::array<NoiseGradient, Count> latticeGradients(double px, double py, double pz) {
    const auto& hash = latticeHash();
    const auto& values = latticeValues();
    const LatticePlace x(px), y(py), z(pz);
    const unsigned column[2] = {hash[x.index], hash[x.index + 1]};
    const double slope[3] = {smoothStepSlope(x.fraction[0]), smoothStepSlope(y.fraction[0]),
                             smoothStepSlope(z.fraction[0])};
    std::array<NoiseGradient, Count> sums{};
    for (unsigned g = 0; g < 2; ++g)
        for (unsigned b = 0; b < 2; ++b)
            for (unsigned a = 0; a < 2; ++a) {
                const unsigned row = hash[column[a] ^ (y.index + b)];
                const double* entry = &values[hash[row ^ (z.index + g)] & 255u];
                const double weight = x.weight[a] * y.weight[b] * z.weight[g];
                const double weightX = (a ? slope[0] : -slope[0]) * y.weight[b] * z.weight[g];
                const double weightY = (b ? slope[1] : -slope[1]) * x.weight[a] * z.weight[g];
                const double weightZ = (g ? slope[2] : -slope[2]) * x.weight[a] * y.weight[b];
                for (std::size_t k = 0; k < Count; ++k) {
                    const double* e = entry + 4 * k;
                    const double plane =
                        e[0] * 0.5 + e[1] * x.fraction[a] + e[2] * y.fraction[b] + e[3] * z.fraction[g];
                    sums[k].value += weight * plane;
                    sums[k].gradient[0] += weightX * plane + weight * e[1];
                    sums[k].gradient[1] += weightY * plane + weight * e[2];
                    sums[k].gradient[2] += weightZ * plane + weight * e[3];
                }
            }
    return sums;
}

NoiseGradient lerp(double t, const NoiseGradient& a, const NoiseGradient& b) {
    NoiseGradient result;
    result.value = a.value + t * (b.value - a.value);
    for (std::size_t axis = 0; axis < 3; ++axis)
        result.gradient[axis] = a.gradient[axis] + t * (b.gradient[axis] - a.gradient[axis]);
    return result;
}

/// Interpolation along `axis`, whose weight S(place) has a derivative of its own.
NoiseGradient lerpAlong(std::size_t axis, double place, const NoiseGradient& a, const NoiseGradient& b) {
    NoiseGradient result = lerp(smoothStep(place), a, b);
    result.gradient[axis] += smoothStepSlope(place) * (b.value - a.value);
    return result;
}

/// clip() of `value`, whose slope in the raw noise is `factor`.
NoiseGradient clipped(double value, double factor, const NoiseGradient& raw) {
    if (value <= 0) return {0, {}};
    if (value >= 1) return {1, {}};
    return {value, {factor * raw.gradient[0], factor * raw.gradient[1], factor * raw.gradient[2]}};
}

}  // namespace

NoiseGradient gradientNoiseWithGradient(double px, double py, double pz) {
    const GradientNoiseTables& tables = gradientNoiseTables();
    const GradientPlace x(px), y(py), z(pz);
    const auto corner = [&](int a, int b, int g) {
        const unsigned row = tables.hash[tables.hash[x.index[a]] + y.index[b]];
        const auto& e = tables.gradients[(row + z.index[g]) & 2047u];
        return NoiseGradient{e[0] * x.distance[a] + e[1] * y.distance[b] + e[2] * z.distance[g],
                             {e[0], e[1], e[2]}};
    };
    const auto plane = [&](int g) {
        return lerpAlong(1, y.distance[0], lerpAlong(0, x.distance[0], corner(0, 0, g), corner(1, 0, g)),
                         lerpAlong(0, x.distance[0], corner(0, 1, g), corner(1, 1, g)));
    };
    return lerpAlong(2, z.distance[0], plane(0), plane(1));
}

NoiseGradient latticeNoiseWithGradient(double x, double y, double z) {
    return latticeGradients<1>(x, y, z)[0];
}

NoiseGradient noiseWithGradient(double generator, double x, double y, double z) {
    const int number = noiseGeneratorNumber(generator);
    if (number == 3) {
        const NoiseGradient raw = gradientNoiseWithGradient(x, y, z);
        return clipped(0.5 * (1.59 * raw.value + 0.985), 0.5 * 1.59, raw);
    }
    const NoiseGradient raw = latticeNoiseWithGradient(x, y, z);
    if (number == 2) return clipped((raw.value + 1.05242) * 0.48985582, 0.48985582, raw);
    return clipped(raw.value + 0.5, 1, raw);
}

std::array<NoiseGradient, 3> vectorNoiseWithGradient(double x, double y, double z) {
    return latticeGradients<3>(x, y, z);
}

}  // namespace isoscope
