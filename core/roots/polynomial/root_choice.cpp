// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/polynomial/root_choice.h"

#include <algorithm>

#include "core/roots/polynomial/polynomial_roots.h"

namespace isoscope {

void chosenRoots(RootChoice choice, std::span<const double> coefficients, double low, double high,
                 RootSequence& roots) {
    const auto* lead = std::find_if(coefficients.data(), coefficients.data() + coefficients.size(),
                                    [](double c) { return c != 0; });
    const std::ptrdiff_t terms = coefficients.data() + coefficients.size() - lead;
    if (choice == RootChoice::isolation || terms > 5) return realRoots(coefficients, low, high, roots);
    roots.clear();
    const auto method = choice == RootChoice::ferrari ? PolynomialMethod::ferrari : PolynomialMethod::vieta;
    for (const double root : polynomialRoots(coefficients, low, high, method)) roots.add(root);
}

}  // namespace isoscope
