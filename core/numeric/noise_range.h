// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/numeric/slope_range.h"

namespace isoscope {

/// What a noise can be over a box.
struct NoiseRange {
    SlopeRange value;
    std::array<SlopeRange, 3> slope;  ///< derivatives in its three coordinates
    double steepness = 0;             ///< at least the length of the gradient
    /// Second derivatives xx, xy, xz, yy, yz, zz. They change abruptly between lattice cells, where the
    /// gradient is continuous: so much and no more does the gradient change with the place.
    std::array<SlopeRange, 6> bend;
};

/// Which noise: a component of the vector noise (0 is L_0, the noise of generators 0 to 2), or gradient
/// noise.
enum class NoiseKind { lattice0, lattice1, lattice2, gradient };

/// Encloses a noise before scaling and clipping, and its gradient, over low <= place <= high; coordinates
/// below 2^31 in magnitude. Over few lattice cells it is tight to second order: in a cell the noise is a
/// polynomial of degree 4 in each coordinate (core/numeric/noise_bounds.h), and a polynomial lies in the
/// convex hull of its Bernstein coefficients on the box; so does the vector of its derivatives, whose longest
/// coefficient bounds the length of the gradient. Over many cells the bounds that hold everywhere are given.
///
/// The quantisation of gradient noise is ignored, as in noise_gradient.h.
NoiseRange noiseRange(NoiseKind kind, const std::array<double, 3>& low, const std::array<double, 3>& high);

}  // namespace isoscope
