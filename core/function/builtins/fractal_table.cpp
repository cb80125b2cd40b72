// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/function/builtins/fractal_table.h"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "core/function/builtins/fractal_orbit.h"

namespace isoscope {

namespace {

/// Colourings by the orbit's place have no bounds worth knowing.
constexpr double farthest = 1e9;

using Complex = fractal::Complex<double>;

/// The same bits: what follows is the same, too.
bool isSame(const Complex& a, const Complex& b) {
    const auto bits = [](double part) { return std::bit_cast<std::uint64_t>(part); };
    return bits(a.re) == bits(b.re) && bits(a.im) == bits(b.im);
}

/// The value where the orbit of a point ends. Orbits that stay inside mostly close after some hundred steps,
/// doubles being finitely many; what is left of the iterations then is whole turns and a rest. Closed ones
/// are found as by Brent, "An improved Monte Carlo factorization algorithm" (1980): each place is compared
/// with that at the last power of two.
template <class Step>
double follow(const Pattern& pattern, double x, double y, Step step) {
    const int count = pattern.iterations;
    const Complex point{x, y};
    const Complex constant =
        fractal::isJulia(pattern.kind) ? Complex{pattern.juliaPoint[0], pattern.juliaPoint[1]} : point;
    const bool fromZero = fractal::fromZero(pattern.kind);
    Complex u = fromZero ? Complex{0, 0} : point;
    double least = fromZero ? 0 : fractal::squaredSize(u);
    Complex mark = u;
    int marked = -1;
    for (int k = 0; k < count; ++k) {
        u = step(u, constant);
        if (fractal::margin(pattern, u) < 0)
            return fractal::colored(pattern.exterior, u, static_cast<double>(k) / count, false);
        const double size = fractal::squaredSize(u);
        least = fromZero && k == 0 ? size : fractal::min(least, size);
        if (isSame(u, mark)) {
            const int turn = k - marked;
            k += (count - 1 - k) / turn * turn;
        } else if (std::has_single_bit(static_cast<unsigned>(k) + 1)) {
            mark = u;
            marked = k;
        }
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
