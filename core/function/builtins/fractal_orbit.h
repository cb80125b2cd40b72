// SPDX-License-Identifier: GPL-3.0-or-later
// The steps and colours of the fractal patterns, for operations of a graph (Expression) and for numbers. The
// specification has mandel with its default colouring; the rest was measured on POV-Ray 3.7.
#pragma once

#include <cmath>

#include "core/function/patterns/pattern.h"

namespace isoscope::fractal {

/// Plain numbers under the names that Expression has, so that a formula is written once for both.
/// number(like, value) is `value` as a T; min takes the first operand at a tie, and the second for a NaN.
inline double sq(double a) { return a * a; }
inline double sqrt(double a) { return std::sqrt(a); }
inline double min(double a, double b) { return a <= b ? a : b; }
inline double number(double, double value) { return value; }
inline Expression number(Expression any, double value) { return any.number(value); }
using isoscope::min;
using isoscope::sq;
using isoscope::sqrt;

/// A complex number whose parts are doubles or expressions of one graph.
template <class T>
struct Complex {
    T re, im;
};

/// Sum, difference, product and square, |a|^2, quotient, and base^exponent for whole exponents of at least 1,
/// by squaring. Neither overflow nor a divisor of 0 is cared for.
template <class T>
Complex<T> operator+(Complex<T> a, Complex<T> b) {
    return {a.re + b.re, a.im + b.im};
}
template <class T>
Complex<T> operator+(Complex<T> a, double b) {
    return {a.re + b, a.im};
}
template <class T>
Complex<T> operator-(Complex<T> a, double b) {
    return {a.re - b, a.im};
}
template <class T>
Complex<T> operator*(double a, Complex<T> b) {
    return {a * b.re, a * b.im};
}
template <class T>
Complex<T> operator*(Complex<T> a, Complex<T> b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
template <class T>
Complex<T> squared(Complex<T> a) {
    return {sq(a.re) - sq(a.im), 2 * a.re * a.im};
}
template <class T>
T squaredSize(Complex<T> a) {
    return sq(a.re) + sq(a.im);
}
template <class T>
Complex<T> operator/(Complex<T> a, Complex<T> b) {
    const T size = squaredSize(b);
    return {(a.re * b.re + a.im * b.im) / size, (a.im * b.re - a.re * b.im) / size};
}
template <class T>
Complex<T> power(Complex<T> base, int exponent) {
    if (exponent == 1) return base;
    const Complex<T> half = squared(power(base, exponent / 2));
    return exponent % 2 == 0 ? half : half * base;
}
/// base^exponent for an exponent known when compiling: to the bit the value of the function above.
template <int exponent, class T>
Complex<T> power(Complex<T> base) {
    if constexpr (exponent == 1) {
        return base;
    } else {
        const Complex<T> half = squared(power<exponent / 2>(base));
        if constexpr (exponent % 2 == 0) return half;
        return half * base;
    }
}

/// Which of the fractal kinds have a magnet's model for a step (magnetMandel, magnetJulia), and which take c
/// from the pattern and not from the point (julia, magnetJulia).
inline bool isMagnet(PatternKind kind) {
    return kind == PatternKind::magnetMandel || kind == PatternKind::magnetJulia;
}
inline bool isJulia(PatternKind kind) {
    return kind == PatternKind::julia || kind == PatternKind::magnetJulia;
}
/// Whether orbits begin at 0, not at the point.
inline bool fromZero(PatternKind kind) { return kind == PatternKind::magnetMandel; }

/// The exponent of mandel and julia; 2 in place of exponents that POV-Ray does not take.
inline int exponentOf(const Pattern& pattern) {
    return pattern.exponent >= 2 && pattern.exponent <= 33 ? pattern.exponent : 2;
}

/// One step: u -> u^n + c, or that of the first or second model of a magnet.
template <class T>
Complex<T> step(const Pattern& pattern, Complex<T> u, Complex<T> c) {
    if (!isMagnet(pattern.kind)) return power(u, exponentOf(pattern)) + c;
    if (pattern.magnetType != 2) return squared((squared(u) + (c - 1)) / (2 * u + (c - 2)));
    const Complex<T> product = (c - 1) * (c - 2);
    const Complex<T> above = power(u, 3) + 3 * ((c - 1) * u) + product;
    const Complex<T> below = 3 * squared(u) + 3 * ((c - 2) * u) + product + 1;
    return squared(above / below);
}

/// Negative where the orbit has ended: it has escaped, or it has come to the fixed point 1 of a magnet.
template <class T>
T margin(const Pattern& pattern, Complex<T> u) {
    if (!isMagnet(pattern.kind)) return 4 - squaredSize(u);
    return min(10000 - squaredSize(u), squaredSize(u - 1) - 1e-4);
}

/// The colouring of an orbit that ends at u; `share` is what type 1 gives.
template <class T>
T colored(const FractalColoring& coloring, Complex<T> u, T share, bool interior) {
    const double factor = coloring.factor;
    switch (coloring.type) {
        case 1: return share;
        case 2: return u.re * factor;
        case 3: return u.im * factor;
        case 4: return sq(u.re) * factor;
        case 5: return sq(u.im) * factor;
        case 6: return interior ? sq(u.re) + sq(u.im) * factor : sqrt(squaredSize(u)) * factor;
        default: return number(u.re, factor);
    }
}

}  // namespace isoscope::fractal
