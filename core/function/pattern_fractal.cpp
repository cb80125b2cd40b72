// SPDX-License-Identifier: GPL-3.0-or-later
// The fractal patterns: mandel, julia, and both for the two models of a magnet. The specification has mandel
// with its default colouring; the rest was measured on POV-Ray 3.7.
#include <algorithm>
#include <vector>

#include "core/function/pattern_call.h"

namespace isoscope {

namespace {

struct Complex {
    Expression re, im;
};

Complex operator+(Complex a, Complex b) { return {a.re + b.re, a.im + b.im}; }
Complex operator+(Complex a, double b) { return {a.re + b, a.im}; }
Complex operator-(Complex a, double b) { return {a.re - b, a.im}; }
Complex operator*(double a, Complex b) { return {a * b.re, a * b.im}; }
Complex operator*(Complex a, Complex b) { return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re}; }
Complex squared(Complex a) { return {sq(a.re) - sq(a.im), 2 * a.re * a.im}; }
Expression squaredSize(Complex a) { return sq(a.re) + sq(a.im); }

Complex operator/(Complex a, Complex b) {
    const Expression size = squaredSize(b);
    return {(a.re * b.re + a.im * b.im) / size, (a.im * b.re - a.re * b.im) / size};
}

Complex power(Complex base, int exponent) {
    if (exponent == 1) return base;
    const Complex half = squared(power(base, exponent / 2));
    return exponent % 2 == 0 ? half : half * base;
}

bool isMagnet(PatternKind kind) {
    return kind == PatternKind::magnetMandel || kind == PatternKind::magnetJulia;
}

/// One step: u -> u^n + c, or that of the first or second model of a magnet.
Complex step(const Pattern& pattern, Complex u, Complex c) {
    if (!isMagnet(pattern.kind)) {
        const bool usable = pattern.exponent >= 2 && pattern.exponent <= 33;
        return power(u, usable ? pattern.exponent : 2) + c;
    }
    if (pattern.magnetType != 2) return squared((squared(u) + (c - 1)) / (2 * u + (c - 2)));
    const Complex product = (c - 1) * (c - 2);
    const Complex above = power(u, 3) + 3 * ((c - 1) * u) + product;
    const Complex below = 3 * squared(u) + 3 * ((c - 2) * u) + product + 1;
    return squared(above / below);
}

/// Negative where the orbit has ended: it has escaped, or it has come to the fixed point 1 of a magnet.
Expression margin(const Pattern& pattern, Complex u) {
    if (!isMagnet(pattern.kind)) return 4 - squaredSize(u);
    return min(10000 - squaredSize(u), squaredSize(u - 1) - 1e-4);
}

/// The colouring of an orbit that ends at u; `share` is what type 1 gives.
Expression colored(const FractalColoring& coloring, Complex u, Expression share, bool interior) {
    const double factor = coloring.factor;
    switch (coloring.type) {
        case 1: return share;
        case 2: return u.re * factor;
        case 3: return u.im * factor;
        case 4: return sq(u.re) * factor;
        case 5: return sq(u.im) * factor;
        case 6: return interior ? sq(u.re) + sq(u.im) * factor : sqrt(squaredSize(u)) * factor;
        default: return u.re.number(factor);
    }
}

}  // namespace

/// All iterations are unrolled; an orbit that has ended takes the value of its last step and nothing behind
/// it.
Expression fractalPattern(const PatternCall& call) {
    const Pattern& pattern = call.pattern;
    const int count = std::clamp(pattern.iterations, 1, fractalIterationLimit);
    const bool isJulia = pattern.kind == PatternKind::julia || pattern.kind == PatternKind::magnetJulia;
    const Complex point{call.x, call.y};
    const Complex constant =
        isJulia ? Complex{call.number(pattern.juliaPoint[0]), call.number(pattern.juliaPoint[1])} : point;
    const bool fromZero = pattern.kind == PatternKind::magnetMandel;
    Complex u = fromZero ? Complex{call.number(0), call.number(0)} : point;
    Expression least = call.number(0);
    if (!fromZero) least = squaredSize(u);
    std::vector<Expression> margins, values;
    for (int k = 0; k < count; ++k) {
        u = step(pattern, u, constant);
        margins.push_back(margin(pattern, u));
        values.push_back(colored(pattern.exterior, u, call.number(static_cast<double>(k) / count), false));
        least = fromZero && k == 0 ? squaredSize(u) : min(least, squaredSize(u));
    }
    Expression value = colored(pattern.interior, u, sqrt(least) * pattern.interior.factor, true);
    for (int k = count; k-- > 0;) value = select(margins[k], values[k], value);
    return value;
}

}  // namespace isoscope
