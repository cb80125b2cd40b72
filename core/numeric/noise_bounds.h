// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace isoscope {

/// How far a noise and its derivatives can go anywhere. Proven by branch and bound over one lattice cell,
/// every combination of table entries at the eight corners admitted (tests/numeric/noise_bounds_test.cpp).
struct NoiseBounds {
    double value;  ///< |N|
    double slope;  ///< |dN/dx|, |dN/dy|, |dN/dz|
    double bend;   ///< |d2N/dx2| and so on
    double twist;  ///< |d2N/dxdy| and so on
};

/// Of L_0, L_1 and L_2 in spec/noise.md, section 4.
constexpr NoiseBounds latticeNoiseBounds{1.6, 4.1, 20, 10};
/// Of K in section 5.
constexpr NoiseBounds gradientNoiseBounds{0.9, 2.3, 12.2, 5.5};

constexpr double vectorNoiseLimit = latticeNoiseBounds.value;

}  // namespace isoscope
