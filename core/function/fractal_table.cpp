// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/function/fractal_table.h"

#include <algorithm>

#include "core/function/fractal_orbit.h"

namespace isoscope {

namespace {

/// Colourings by the orbit's place have no bounds worth knowing.
constexpr double farthest = 1e9;

}  // namespace

double FractalTable::value(const std::array<double, 3>& point) const {
    const double value = valueOf(point[0], point[1]);
    return value >= low() ? std::min(value, high()) : low();
}

double FractalTable::low() const { return -farthest; }
double FractalTable::high() const { return farthest; }

double FractalTable::valueOf(double x, double y) const {
    using Complex = fractal::Complex<double>;
    const int count = pattern_.iterations;
    const Complex point{x, y};
    const Complex constant =
        fractal::isJulia(pattern_.kind) ? Complex{pattern_.juliaPoint[0], pattern_.juliaPoint[1]} : point;
    const bool fromZero = fractal::fromZero(pattern_.kind);
    Complex u = fromZero ? Complex{0, 0} : point;
    double least = fromZero ? 0 : fractal::squaredSize(u);
    for (int k = 0; k < count; ++k) {
        u = fractal::step(pattern_, u, constant);
        if (fractal::margin(pattern_, u) < 0)
            return fractal::colored(pattern_.exterior, u, static_cast<double>(k) / count, false);
        const double size = fractal::squaredSize(u);
        least = fromZero && k == 0 ? size : fractal::min(least, size);
    }
    return fractal::colored(pattern_.interior, u, std::sqrt(least) * pattern_.interior.factor, true);
}

}  // namespace isoscope
