// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

namespace isoscope {

/// How the real roots of a polynomial are found. The names are those of the scene languages: POV-Ray's
/// `sturm`, VirtuaLight's FerrariSolver and VietaSolver, both for degree 4.
enum class PolynomialMethod {
    sturm,    ///< any degree: isolates every sign change between critical points, then narrows it down
    ferrari,  ///< closed form up to degree 4, polished; a higher degree falls back to `sturm`
    vieta,  ///< the same: Vieta's trigonometric formula solves degree 3, and Ferrari's resolvent of degree 4
};

/// Whether roots count through which the polynomial keeps its sign.
enum class TouchingRoots { found, leftOut };

/// The real roots of c[0] t^n + c[1] t^(n-1) + ... + c[n] with low <= t <= high, in rising order, each once.
/// Leading zeros are allowed. Nothing for the zero polynomial, for coefficients that are not finite and for
/// an empty interval.
///
/// `sturm` separates roots by the sign changes between consecutive critical points, which are found the same
/// way from the derivatives, all in at least 100 bits: every sign change that double precision resolves is
/// found, to within one unit in the last place of its true position. A root of even multiplicity is found
/// only where the value is exactly 0, and left out on request (but at the ends of the interval, where one
/// side is unknown).
std::vector<double> polynomialRoots(std::span<const double> coefficients, double low, double high,
                                    PolynomialMethod method = PolynomialMethod::sturm,
                                    TouchingRoots touching = TouchingRoots::found);

}  // namespace isoscope
