// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>

namespace isoscope {

/// S(t) of docs/povray/noise.md and its derivative.
inline double smoothStep(double t) { return t * t * (3 - 2 * t); }
inline double smoothStepSlope(double t) { return 6 * t * (1 - t); }

/// Coordinates without a lattice cell are taken as 0.
inline double latticeCoordinate(double t) { return std::abs(t) < 2147483648.0 ? t : 0; }

/// A coordinate on the lattice: the cell's index and the place in it.
struct LatticePlace {
    explicit LatticePlace(double coordinate) {
        const double t = latticeCoordinate(coordinate);
        // A negative coordinate just below an integer belongs to that integer's cell.
        const auto cell = static_cast<std::int32_t>(t >= 0 ? t : t - (1 - 1e-10));
        index = (static_cast<std::uint32_t>(cell) + 10000u) & 4095u;
        fraction[0] = t - cell;
        fraction[1] = fraction[0] - 1;
        weight[1] = smoothStep(fraction[0]);
        weight[0] = 1 - weight[1];
    }
    std::uint32_t index;
    double fraction[2];
    double weight[2];
};

/// A coordinate of gradient noise: the two hash indices and the distances from both ends.
struct GradientPlace {
    explicit GradientPlace(double coordinate) {
        const double shifted = latticeCoordinate(coordinate) + 10000000.023157213;
        const double base = std::floor(shifted);
        index[0] = static_cast<unsigned>(static_cast<std::int64_t>(base)) & 2047u;
        index[1] = (index[0] + 1) & 2047u;
        distance[0] = shifted - base;
        distance[1] = distance[0] - 1;
    }
    unsigned index[2];
    double distance[2];
};

}  // namespace isoscope
