// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/isosurface/julia_algebra.h"

namespace isoscope {

Complex juliaFunction(JuliaFunction function, const Complex& z, const Complex& exponent) {
    using F = JuliaFunction;
    switch (function) {
        case F::sqr: return z * z;
        case F::cube: return z * z * z;
        case F::exp: return std::exp(z);
        case F::reciprocal: return 1.0 / z;
        case F::sin: return std::sin(z);
        case F::asin: return std::asin(z);
        case F::sinh: return std::sinh(z);
        case F::asinh: return std::asinh(z);
        case F::cos: return std::cos(z);
        // The branches are POV-Ray's, which differ from the standard library's.
        case F::acos: return Complex(0, -1) * std::log(z + std::sqrt(z * z - 1.0));
        case F::cosh: return std::cosh(z);
        case F::acosh: return std::log(z + std::sqrt(z * z - 1.0));
        case F::tan: return std::tan(z);
        case F::atan: return std::atan(z);
        case F::tanh: return std::tanh(z);
        case F::atanh: return std::atanh(z);
        case F::ln: return std::log(z);
        case F::pwr: return std::pow(z, exponent);
    }
    return z;
}

Complex juliaSlope(JuliaFunction function, const Complex& z, const Complex& exponent) {
    using F = JuliaFunction;
    switch (function) {
        case F::sqr: return 2.0 * z;
        case F::cube: return 3.0 * z * z;
        case F::exp: return std::exp(z);
        case F::reciprocal: return -1.0 / (z * z);
        case F::sin: return std::cos(z);
        case F::asin: return 1.0 / std::sqrt(1.0 - z * z);
        case F::sinh: return std::cosh(z);
        case F::asinh: return 1.0 / std::sqrt(1.0 + z * z);
        case F::cos: return -std::sin(z);
        case F::acos: return Complex(0, -1) / std::sqrt(z * z - 1.0);
        case F::cosh: return std::sinh(z);
        case F::acosh: return 1.0 / std::sqrt(z * z - 1.0);
        case F::tan: return 1.0 / (std::cos(z) * std::cos(z));
        case F::atan: return 1.0 / (1.0 + z * z);
        case F::tanh: return 1.0 / (std::cosh(z) * std::cosh(z));
        case F::atanh: return 1.0 / (1.0 - z * z);
        case F::ln: return 1.0 / z;
        case F::pwr: return exponent * std::pow(z, exponent - 1.0);
    }
    return 1;
}

}  // namespace isoscope
