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
constexpr NoiseBounds latticeNoiseBounds{1.65, 4.25, 21, 10.6};
/// Of K in section 5.
constexpr NoiseBounds gradientNoiseBounds{0.92, 2.4, 12.8, 5.8};

constexpr double vectorNoiseLimit = latticeNoiseBounds.value;

}  // namespace isoscope
