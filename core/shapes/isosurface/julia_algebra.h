// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/geometric.hpp>

#include "core/shapes/isosurface/julia_fractal.h"

namespace isoscope {

using Complex = std::complex<double>;

/// i j = k, and so on in a circle; i i = j j = k k = -1. Components are 1, i, j, k.
inline glm::dvec4 quaternionProduct(const glm::dvec4& a, const glm::dvec4& b) {
    return {a.x * b.x - a.y * b.y - a.z * b.z - a.w * b.w, a.x * b.y + a.y * b.x + a.z * b.w - a.w * b.z,
            a.x * b.z + a.z * b.x + a.w * b.y - a.y * b.w, a.x * b.w + a.w * b.x + a.y * b.z - a.z * b.y};
}

/// A hypercomplex number as the pair of complex numbers on which functions act one by one.
struct ComplexPair {
    Complex a, b;

    explicit ComplexPair(const glm::dvec4& h) : a(h.x - h.w, h.y + h.z), b(h.x + h.w, h.y - h.z) {}
    /// The squared length of the hypercomplex number as a vector of four components.
    double squaredNorm() const { return (std::norm(a) + std::norm(b)) / 2; }
};

/// The function and its derivative at z; `exponent` is that of pwr, unused by the others. The branches of
/// acos and acosh are POV-Ray's, which differ from the standard library's. At poles the results are not
/// finite.
Complex juliaFunction(JuliaFunction function, const Complex& z, const Complex& exponent);
Complex juliaSlope(JuliaFunction function, const Complex& z, const Complex& exponent);

}  // namespace isoscope
