// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/polynomial/polynomial_roots.h"

#include <algorithm>
#include <cmath>

#include "core/roots/polynomial/polynomial_closed_form.h"
#include "core/roots/polynomial/wide_number.h"

namespace isoscope {

namespace {

using WidePolynomial = std::vector<Wide>;  // highest power first

Wide valueAt(const WidePolynomial& polynomial, Wide t) {
    Wide value = 0;
    for (const Wide coefficient : polynomial) value = value * t + coefficient;
    return value;
}

int signAt(const WidePolynomial& polynomial, Wide t) {
    const Wide value = valueAt(polynomial, t);
    return value < 0 ? -1 : value > 0 ? 1 : 0;
}

WidePolynomial derivative(const WidePolynomial& polynomial) {
    const std::size_t degree = polynomial.size() - 1;
    WidePolynomial result(degree);
    for (std::size_t k = 0; k < degree; ++k) result[k] = polynomial[k] * Wide(degree - k);
    return result;
}

/// The sign change in (a, b), on which the polynomial is monotone with these signs at the ends. Newton's
/// steps are taken while they stay inside and shrink the bracket faster than halving would.
Wide narrow(const WidePolynomial& polynomial, const WidePolynomial& slope, Wide a, Wide b, int signA) {
    constexpr int stepLimit = 400;  // halving a bracket of any two doubles to nothing takes fewer
    Wide t = (a + b) / 2;
    for (int step = 0; step < stepLimit && a < t && t < b; ++step) {
        const Wide value = valueAt(polynomial, t);
        if (value == 0) return t;
        ((value < 0) == (signA < 0) ? a : b) = t;
        const Wide newton = t - value / valueAt(slope, t);
        const Wide middle = (a + b) / 2;
        const Wide reach = (b - a) / 8;
        // A NaN or a far step fails the comparison and halves instead.
        const bool isUseful = newton > middle - 4 * reach && newton < middle + 4 * reach && step % 3 != 2;
        if (isUseful && newton == t) return t;
        t = isUseful ? newton : middle;
    }
    return t;
}

/// Sign changes and exact zeros of the polynomial in [low, high], in rising order.
std::vector<Wide> signChanges(const WidePolynomial& polynomial, Wide low, Wide high,
                              TouchingRoots touching = TouchingRoots::found) {
    std::vector<Wide> roots;
    if (polynomial.size() < 2) return roots;
    const WidePolynomial slope = derivative(polynomial);
    std::vector<Wide> ends{low};
    for (const Wide critical : signChanges(slope, low, high))
        if (critical > ends.back() && critical < high) ends.push_back(critical);
    ends.push_back(high);

    int sign = signAt(polynomial, low), signBeforeZero = 0;
    if (sign == 0) roots.push_back(low);
    for (std::size_t k = 1; k < ends.size(); ++k) {
        const int next = signAt(polynomial, ends[k]);
        if (next == 0 && (roots.empty() || roots.back() < ends[k]))
            roots.push_back(ends[k]);
        else if (sign * next < 0)
            roots.push_back(narrow(polynomial, slope, ends[k - 1], ends[k], sign));
        // Between critical points, a zero at one of them is followed by a sign.
        if (touching == TouchingRoots::leftOut && sign == 0 && next != 0 && next == signBeforeZero)
            roots.pop_back();
        signBeforeZero = next == 0 ? sign : 0;
        sign = next;
    }
    return roots;
}

/// Without leading zeros, scaled by a power of two to a size where no intermediate value over- or underflows.
WidePolynomial prepared(std::span<const double> coefficients) {
    double largest = 0;
    for (const double coefficient : coefficients) {
        if (!std::isfinite(coefficient)) return {};
        largest = std::max(largest, std::abs(coefficient));
    }
    if (largest == 0) return {};
    const int exponent = std::ilogb(largest);
    WidePolynomial polynomial;
    for (const double coefficient : coefficients) {
        // In two steps: 2^-exponent itself may overflow.
        const Wide scaled = Wide(coefficient) * Wide(std::ldexp(1.0, -exponent / 2)) *
                            Wide(std::ldexp(1.0, -(exponent - exponent / 2)));
        if (!polynomial.empty() || scaled != 0) polynomial.push_back(scaled);
    }
    return polynomial;
}

}  // namespace

std::vector<double> polynomialRoots(std::span<const double> coefficients, double low, double high,
                                    PolynomialMethod method, TouchingRoots touching) {
    const WidePolynomial polynomial = prepared(coefficients);
    if (polynomial.size() < 2 || !(low <= high) || !std::isfinite(low) || !std::isfinite(high)) return {};
    const std::size_t closedDegree = method == PolynomialMethod::sturm ? 0 : 4;
    std::vector<double> roots;
    if (polynomial.size() - 1 <= closedDegree) {
        for (const Wide root : closedFormRoots(polynomial)) roots.push_back(static_cast<double>(root));
        std::erase_if(roots, [&](double root) { return !(root >= low && root <= high); });
        std::sort(roots.begin(), roots.end());
    } else {
        for (const Wide root : signChanges(polynomial, low, high, touching))
            roots.push_back(static_cast<double>(root));
    }
    roots.erase(std::unique(roots.begin(), roots.end()), roots.end());
    return roots;
}

}  // namespace isoscope
