// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/function/builtins/fractal_table.h"

#include <algorithm>

#include "core/function/builtins/fractal_orbit.h"

namespace isoscope {

namespace {

/// Colourings by the orbit's place have no bounds worth knowing.
constexpr double farthest = 1e9;

using Complex = fractal::Complex<double>;

/// The value where the orbit of a point ends.
template <class Step>
double follow(const Pattern& pattern, double x, double y, Step step) {
    const int count = pattern.iterations;
    const Complex point{x, y};
    const Complex constant =
        fractal::isJulia(pattern.kind) ? Complex{pattern.juliaPoint[0], pattern.juliaPoint[1]} : point;
    const bool fromZero = fractal::fromZero(pattern.kind);
    Complex u = fromZero ? Complex{0, 0} : point;
    double least = fromZero ? 0 : fractal::squaredSize(u);
    for (int k = 0; k < count; ++k) {
        u = step(u, constant);
        if (fractal::margin(pattern, u) < 0)
            return fractal::colored(pattern.exterior, u, static_cast<double>(k) / count, false);
        const double size = fractal::squaredSize(u);
        least = fromZero && k == 0 ? size : fractal::min(least, size);
    }
    return fractal::colored(pattern.interior, u, std::sqrt(least) * pattern.interior.factor, true);
}

}  // namespace

double FractalTable::value(const std::array<double, 3>& point) const {
    const double value = valueOf(point[0], point[1]);
    return value >= low() ? std::min(value, high()) : low();
}

double FractalTable::low() const { return -farthest; }
double FractalTable::high() const { return farthest; }

double FractalTable::valueOf(double x, double y) const {
    // The most common steps, with the exponent known to the compiler: orbits are thousands of steps long.
    if (!fractal::isMagnet(pattern_.kind) && fractal::exponentOf(pattern_) == 2)
        return follow(pattern_, x, y, [](Complex u, Complex c) { return fractal::power<2>(u) + c; });
    if (!fractal::isMagnet(pattern_.kind) && fractal::exponentOf(pattern_) == 3)
        return follow(pattern_, x, y, [](Complex u, Complex c) { return fractal::power<3>(u) + c; });
    return follow(pattern_, x, y, [this](Complex u, Complex c) { return fractal::step(pattern_, u, c); });
}

}  // namespace isoscope
