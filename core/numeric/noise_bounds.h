// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace isoscope {

/// How far a noise and its derivatives can go anywhere, for interval and Lipschitz methods; proven.
struct NoiseBounds {
    double low;        ///< of the value
    double high;       ///< of the value
    double value;      ///< |N|
    double slope;      ///< |dN/dx|, |dN/dy|, |dN/dz|
    double bend;       ///< |d2N/dx2| and so on
    double twist;      ///< |d2N/dxdy| and so on
    double lipschitz;  ///< length of the gradient
    double curvature;  ///< spectral norm of the second derivatives
};

/// How the bounds are proven. In a cell of the lattice each noise is a sum over the eight corners c,
///     N(f) = sum p_c(f) . w(n_c),
///     p_c = W_c * (1, fx - a, fy - b, fz - g),
///     W_c = w_a(fx) w_b(fy) w_g(fz),
/// where f is the place in the cell, (a, b, g) the corner, W_c its weight (docs/povray/noise.md, section 4)
/// and w(n_c) what the hash picks for it: (V[n]/2, V[n+1], V[n+2], V[n+3]) with one of 256 values of n for
/// L_0, from 4 or 8 places further on for L_1 and L_2, and (0, unit gradient) for gradient noise. Derivatives
/// of N along a direction are the same sum with derivatives of the polynomials p_c. So for every choice that
/// any hash could make,
///     D N(f) <= sum over c of max over n of (D p_c)(f) . w(n).
/// The right side is bounded over the unit cube by halving boxes with interval bounds of the polynomials, for
/// the value, for the first and second derivatives along the axes, and for those along so many
/// directions that every other one is near to one of them: a gradient at an angle t from a direction shows at
/// least cos(t) of its length there, the largest curvature at least cos(2t) of its size. Gradient noise takes
/// all unit vectors for the table of 2048. tests/numeric/noise_bounds_test.cpp carries the proof out (a part
/// of the directions; all of them with ISOSCOPE_FULL_PROOFS=1 in the environment).
///
/// Between cells value and gradient are continuous, because the derivative of the weights is 0 at both ends
/// and the terms there depend on the common face alone; so the gradient is Lipschitz with `curvature` across
/// cells too. The places within 1e-10 below a whole negative coordinate, which are counted to the cell above,
/// differ from this continuous function by less than rounding does. Rounding changes a value by at most
/// `noiseRounding`.
///
/// The bounds do not use which combinations the hash really makes. Random search in 2e7 cells found L_0 in
/// [-1.06, 1.08], gradients up to 2.9 and curvatures up to 13.8.
constexpr NoiseBounds latticeNoiseBounds{-1.52, 1.42, 1.52, 3.95, 19.6, 10, 4.2, 21};

/// The third derivative of L_0, L_1 and L_2 along any direction within a cell, where they have one; proven in
/// the same way. A form of degree 3 in the direction has at least cos(3t) of its size at an angle t from
/// where it is largest.
constexpr double latticeThirdDerivative = 105;

/// `curvature` of L_0, L_1 and L_2 within a plane of lattice points, where y is a whole number; proven in the
/// same way, with boxes of the plane and directions along it.
constexpr double latticePlaneCurvature = 16.6;

/// K of gradient noise. POV-Ray rounds the coordinates to multiples of 2^-29 (while they are below 6.7e6 in
/// magnitude): the computed noise differs from the smooth one by up to lipschitz * sqrt(3) * 2^-30.
constexpr NoiseBounds gradientNoiseBounds{-0.87, 0.87, 0.87, 2.25, 12, 5.5, 2.35, 13};

constexpr double noiseRounding = 1e-14;

/// Each component of vectorNoise(), which is never clipped.
constexpr double vectorNoiseLimit = latticeNoiseBounds.value;

/// Bounds of noise() with generator 0 to 3 before it is clipped to [0, 1]. The clipping leaves `slope` and
/// `lipschitz` valid but puts kinks where it begins: the second derivatives are those of the unclipped noise.
constexpr NoiseBounds unclippedNoiseBounds(int generator) {
    const auto scaled = [](const NoiseBounds& b, double offset, double scale) {
        const double low = (b.low + offset) * scale, high = (b.high + offset) * scale;
        return NoiseBounds{low,
                           high,
                           -low > high ? -low : high,
                           b.slope * scale,
                           b.bend * scale,
                           b.twist * scale,
                           b.lipschitz * scale,
                           b.curvature * scale};
    };
    if (generator == 2) return scaled(latticeNoiseBounds, 1.05242, 0.48985582);
    if (generator == 3) return scaled(gradientNoiseBounds, 0.985 / 1.59, 0.5 * 1.59);
    return scaled(latticeNoiseBounds, 0.5, 1);
}

}  // namespace isoscope
