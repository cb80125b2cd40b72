// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <utility>

#include "core/numeric/noise_range.h"

namespace isoscope {

/// Lanes that hold the Bernstein coefficients of a polynomial of degree 4: five, and the last one again, so
/// that ranges over all lanes are those over the coefficients.
constexpr std::size_t noiseLanes = 8;
using NoiseCoefficients = std::array<double, noiseLanes>;

/// The functions along one axis of a lattice cell, over a part of it: the weights of both ends, and those
/// times the distance from the end; with their first and second derivatives.
struct NoiseAxisPart {
    static constexpr std::size_t coefficients = 5;

    alignas(64) std::array<NoiseCoefficients, 4> value, slope, bend;
    std::size_t count = coefficients;  ///< of different coefficients: 1 at a single place

    /// Over [low, high], places in the cell from 0 to 1.
    explicit NoiseAxisPart(std::pair<double, double> part);
};

/// What each product of three axis functions counts in a cell: [x][y][z], 0 and 1 the weights, 2 and 3 the
/// weights times the distance.
using NoiseFactors = std::array<std::array<std::array<double, 4>, 4>, 4>;

/// Widens `range` by the coefficients of one cell; `steepness` is that of the square until all are in.
void includeNoiseCell(const NoiseFactors& factors, const std::array<const NoiseAxisPart*, 3>& parts,
                      NoiseRange& range);

}  // namespace isoscope
