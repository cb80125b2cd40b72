// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numeric/noise.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace isoscope {

namespace {

double clip(double t) { return std::min(1.0, std::max(0.0, t)); }

double smooth(double t) { return t * t * (3 - 2 * t); }

double meaningful(double t) { return std::abs(t) < 2147483648.0 ? t : 0; }

/// A coordinate on the lattice: the cell's index and the place in it.
struct LatticePlace {
    explicit LatticePlace(double coordinate) {
        const double t = meaningful(coordinate);
        // A negative coordinate just below an integer belongs to that integer's cell.
        const auto cell = static_cast<std::int32_t>(t >= 0 ? t : t - (1 - 1e-10));
        index = (static_cast<std::uint32_t>(cell) + 10000u) & 4095u;
        fraction[0] = t - cell;
        fraction[1] = fraction[0] - 1;
        weight[1] = smooth(fraction[0]);
        weight[0] = 1 - weight[1];
    }
    std::uint32_t index;
    double fraction[2];
    double weight[2];
};

/// L_0 .. L_(Count-1). The corners are summed with x fastest and the products formed in this order because
/// the last bit depends on it.
template <int Count>
std::array<double, Count> latticeSums(double px, double py, double pz) {
    const auto& hash = latticeHash();
    const auto& values = latticeValues();
    const LatticePlace x(px), y(py), z(pz);
    const unsigned column[2] = {hash[x.index], hash[x.index + 1]};
    std::array<double, Count> sums{};
    for (unsigned g = 0; g < 2; ++g)
        for (unsigned b = 0; b < 2; ++b)
            for (unsigned a = 0; a < 2; ++a) {
                const unsigned row = hash[column[a] ^ (y.index + b)];
                const double* entry = &values[hash[row ^ (z.index + g)] & 255u];
                const double weight = x.weight[a] * y.weight[b] * z.weight[g];
                for (int k = 0; k < Count; ++k)
                    sums[k] += weight * (entry[4 * k] * 0.5 + entry[4 * k + 1] * x.fraction[a] +
                                         entry[4 * k + 2] * y.fraction[b] + entry[4 * k + 3] * z.fraction[g]);
            }
    return sums;
}

/// A coordinate of gradient noise: the two hash indices and the distances from both ends.
struct GradientPlace {
    explicit GradientPlace(double coordinate) {
        const double shifted = meaningful(coordinate) + 10000000.023157213;
        const double base = std::floor(shifted);
        index[0] = static_cast<unsigned>(static_cast<std::int64_t>(base)) & 2047u;
        index[1] = (index[0] + 1) & 2047u;
        distance[0] = shifted - base;
        distance[1] = distance[0] - 1;
    }
    unsigned index[2];
    double distance[2];
};

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
    const double sx = smooth(x.distance[0]), sy = smooth(y.distance[0]), sz = smooth(z.distance[0]);
    const auto plane = [&](int g) {
        return lerp(sy, lerp(sx, corner(0, 0, g), corner(1, 0, g)),
                    lerp(sx, corner(0, 1, g), corner(1, 1, g)));
    };
    return lerp(sz, plane(0), plane(1));
}

double noise(double generator, double x, double y, double z) {
    switch (noiseGeneratorNumber(generator)) {
        case 2:
            return clip((latticeNoise(x, y, z) + 1.05242) * 0.48985582);
        case 3:
            return clip(0.5 * (1.59 * gradientNoise(x, y, z) + 0.985));
        default:
            return clip(latticeNoise(x, y, z) + 0.5);
    }
}

}  // namespace isoscope
