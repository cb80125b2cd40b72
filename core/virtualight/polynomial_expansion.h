// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/function/function_graph.h"
#include "core/virtualight/primitive.h"

namespace isoscope::virtualight {

/// The highest order of a PolynomialSurface.
constexpr int polynomialOrderLimit = 21;

/// A polynomial of order 2 or more, or the reason why a function is none.
struct PolynomialExpansion {
    PolynomialShape polynomial;
    std::string problem;   ///< why there is none, a sentence; empty when there is one
    std::size_t work = 0;  ///< products of two terms that it took
};

/// Multiplies a function of x, y and z (arguments 0 to 2, no parameters) out into a polynomial.
PolynomialExpansion expandPolynomial(const Function& function);

}  // namespace isoscope::virtualight
