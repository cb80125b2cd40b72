// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numeric/noise.h"

#include <algorithm>
#include <cmath>

#include "core/numeric/noise_place.h"

namespace isoscope {

namespace {

double clip(double t) { return std::min(1.0, std::max(0.0, t)); }

/// L_0 .. L_(Count-1). The corners are summed with x fastest and the products formed in this order because
/// the last bit depends on it.
template <int Count>
std::array<double, Count> latticeSums(double px, double py, double pz) {
    const auto& hash = latticeHash();
    const auto& values = latticeValues();
    const LatticePlace x(px), y(py), z(pz);
    const unsigned left = hash[x.index], right = hash[x.index + 1];
    const unsigned rows[4] = {hash[left ^ y.index], hash[right ^ y.index], hash[left ^ (y.index + 1)],
                              hash[right ^ (y.index + 1)]};
    const double areas[4] = {x.weight[0] * y.weight[0], x.weight[1] * y.weight[0], x.weight[0] * y.weight[1],
                             x.weight[1] * y.weight[1]};
    std::array<double, Count> sums{};
    const auto addCorner = [&](unsigned a, unsigned b, unsigned g) {
        const double* entry = &values[hash[rows[a + 2 * b] ^ (z.index + g)] & 255u];
        const double weight = areas[a + 2 * b] * z.weight[g];
        for (std::size_t k = 0; k < Count; ++k)
            sums[k] += weight * (entry[4 * k] * 0.5 + entry[4 * k + 1] * x.fraction[a] +
                                 entry[4 * k + 2] * y.fraction[b] + entry[4 * k + 3] * z.fraction[g]);
    };
    for (unsigned g = 0; g < 2; ++g) {
        addCorner(0, 0, g);
        addCorner(1, 0, g);
        addCorner(0, 1, g);
        addCorner(1, 1, g);
    }
    return sums;
}

double lerp(double t, double a, double b) { return a + t * (b - a); }

}  // namespace

int noiseGeneratorNumber(double generator) {
    const bool fits = generator > -2147483649.0 && generator < 2147483648.0;
    return fits ? static_cast<int>(static_cast<std::uint32_t>(static_cast<std::int32_t>(generator)) & 3u) : 0;
}

double latticeNoise(double x, double y, double z) { return latticeSums<1>(x, y, z)[0]; }

std::array<double, 3> vectorNoise(double x, double y, double z) { return latticeSums<3>(x, y, z); }

double gradientNoise(double px, double py, double pz) {
    const GradientNoiseTables& tables = gradientNoiseTables();
    const GradientPlace x(px), y(py), z(pz);
    const auto corner = [&](int a, int b, int g) {
        const unsigned row = tables.hash[tables.hash[x.index[a]] + y.index[b]];
        const auto& gradient = tables.gradients[(row + z.index[g]) & 2047u];
        return gradient[0] * x.distance[a] + gradient[1] * y.distance[b] + gradient[2] * z.distance[g];
    };
    const double sx = smoothStep(x.distance[0]), sy = smoothStep(y.distance[0]),
                 sz = smoothStep(z.distance[0]);
    const auto plane = [&](int g) {
        return lerp(sy, lerp(sx, corner(0, 0, g), corner(1, 0, g)),
                    lerp(sx, corner(0, 1, g), corner(1, 1, g)));
    };
    return lerp(sz, plane(0), plane(1));
}

double noise(double generator, double x, double y, double z) {
    switch (noiseGeneratorNumber(generator)) {
        case 2: return clip((latticeNoise(x, y, z) + 1.05242) * 0.48985582);
        case 3: return clip(0.5 * (1.59 * gradientNoise(x, y, z) + 0.985));
        default: return clip(latticeNoise(x, y, z) + 0.5);
    }
}

}  // namespace isoscope
