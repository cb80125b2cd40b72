// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/polynomial/polynomial_closed_form.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isoscope {

namespace {

Wide magnitude(Wide a) { return a < 0 ? -a : a; }

/// Newton's steps from a good start; stops when the value no longer shrinks.
Wide polished(const std::vector<Wide>& polynomial, Wide t) {
    Wide best = t, bestValue = -1;
    for (int step = 0; step < 12; ++step) {
        Wide value = 0, slope = 0;
        for (const Wide coefficient : polynomial) {
            slope = slope * t + value;
            value = value * t + coefficient;
        }
        if (bestValue >= 0 && !(magnitude(value) < bestValue)) break;
        best = t;
        bestValue = magnitude(value);
        if (value == 0 || slope == 0) break;
        t -= value / slope;
    }
    return best;
}

std::vector<Wide> quadraticRoots(Wide a, Wide b, Wide c) {
    const Wide discriminant = b * b - 4 * a * c;
    if (discriminant < 0) return {};
    const Wide root = squareRoot(discriminant);
    // The sum of equal signs does not cancel; the other root follows from the product.
    const Wide q = b < 0 ? (root - b) / 2 : -(root + b) / 2;
    if (q == 0) return {Wide(0)};
    return {q / a, c / q};
}

/// t^3 + a t^2 + b t + c.
std::vector<Wide> monicCubicRoots(Wide a, Wide b, Wide c) {
    const Wide shift = a / 3;
    const Wide p = b - a * shift;
    const Wide q = c - shift * b + 2 * shift * shift * shift;
    const Wide discriminant = q * q / 4 + p * p * p / 27;
    std::vector<Wide> roots;
    if (discriminant > 0) {
        const Wide root = squareRoot(discriminant);
        const Wide larger = q < 0 ? root - q / 2 : -root - q / 2;
        const Wide u = std::cbrt(static_cast<double>(larger));
        roots.push_back(u - (u == 0 ? Wide(0) : p / (3 * u)) - shift);
    } else {
        const auto radius = static_cast<double>(squareRoot(-p / 3));
        const double cosine = radius == 0 ? 0 : static_cast<double>(-q / 2) / (radius * radius * radius);
        const double angle = std::acos(std::clamp(cosine, -1.0, 1.0)) / 3;
        for (int k = 0; k < 3; ++k)
            roots.push_back(2 * radius * std::cos(angle - 2 * std::numbers::pi * k / 3) - shift);
    }
    for (Wide& root : roots) root = polished({1, a, b, c}, root);
    return roots;
}

/// t^4 + a t^3 + b t^2 + c t + d.
std::vector<Wide> monicQuarticRoots(Wide a, Wide b, Wide c, Wide d) {
    const Wide shift = a / 4;
    const Wide p = b - 6 * shift * shift;
    const Wide q = c - 2 * b * shift + 8 * shift * shift * shift;
    const Wide r = d - c * shift + b * shift * shift - 3 * shift * shift * shift * shift;
    std::vector<Wide> roots;
    if (q == 0) {
        for (const Wide square : quadraticRoots(1, p, r)) {
            if (square < 0) continue;
            roots.push_back(squareRoot(square));
            roots.push_back(-squareRoot(square));
        }
    } else {
        // Ferrari's resolvent m^3 + p m^2 + (p^2/4 - r) m - q^2/8 has a positive root, for it is negative at
        // 0.
        const std::vector<Wide> resolvent = monicCubicRoots(p, p * p / 4 - r, -q * q / 8);
        const Wide m = *std::max_element(resolvent.begin(), resolvent.end());
        const Wide s = squareRoot(2 * m);
        for (const Wide sign : {Wide(1), Wide(-1)})
            for (const Wide root : quadraticRoots(1, sign * s, p / 2 + m - sign * q / (2 * s)))
                roots.push_back(root);
    }
    for (Wide& root : roots) root -= shift;
    return roots;
}

}  // namespace

std::vector<Wide> closedFormRoots(const std::vector<Wide>& polynomial) {
    const Wide a = polynomial[0];
    std::vector<Wide> roots;
    switch (polynomial.size() - 1) {
        case 1: return {-polynomial[1] / a};
        case 2: roots = quadraticRoots(a, polynomial[1], polynomial[2]); break;
        case 3: roots = monicCubicRoots(polynomial[1] / a, polynomial[2] / a, polynomial[3] / a); break;
        case 4:
            roots =
                monicQuarticRoots(polynomial[1] / a, polynomial[2] / a, polynomial[3] / a, polynomial[4] / a);
            break;
        default: return {};
    }
    for (Wide& root : roots) root = polished(polynomial, root);
    return roots;
}

}  // namespace isoscope
