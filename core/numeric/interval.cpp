// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numeric/interval.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace isoscope {

namespace {

constexpr double infinite = Interval::infinite;

// Sums, products, quotients and roots are rounded to nearest, so the neighbours enclose the true result.
// As std::nextafter(), which is a call of the library.
double up(double a) {
    if (!(a < infinite)) return a;
    if (a == 0) return std::numeric_limits<double>::denorm_min();
    const auto bits = std::bit_cast<std::int64_t>(a);
    return std::bit_cast<double>(a > 0 ? bits + 1 : bits - 1);
}
double down(double a) { return -up(-a); }

// The standard library's functions are within 2 units in the last place; this is more than 4.
double libraryError(double a) { return std::abs(a) * 1e-15 + std::numeric_limits<double>::denorm_min(); }
double libraryDown(double a) {
    return std::isinf(a) ? (a > 0 ? std::numeric_limits<double>::max() : a) : a - libraryError(a);
}
double libraryUp(double a) {
    return std::isinf(a) ? (a < 0 ? std::numeric_limits<double>::lowest() : a) : a + libraryError(a);
}

/// 0 times infinity is 0: an infinite end stands for numbers without limit, not for infinity itself.
double product(double a, double b) { return a == 0 || b == 0 ? 0 : a * b; }

/// The part of `a` inside [low, high], where a function is defined.
Interval restrict(const Interval& a, double low, double high) {
    Interval part{std::max(a.low, low), std::min(a.high, high), a.maybeUndefined};
    if (part.empty()) return Interval::undefined();
    part.maybeUndefined = a.maybeUndefined || a.low < low || a.high > high;
    return part;
}

/// A function that never falls.
template <class Function>
Interval rising(const Interval& a, Function function) {
    if (a.empty()) return Interval::undefined();
    return {libraryDown(function(a.low)), libraryUp(function(a.high)), a.maybeUndefined};
}

Interval within(const Interval& a, double low, double high) {
    if (a.empty()) return a;
    return {std::max(a.low, low), std::min(a.high, high), a.maybeUndefined};
}

/// Whether a number `offset` + k `period` may lie in [low, high].
bool mayHold(double low, double high, double offset, double period) {
    const double slack = 1e-14 * (1 + std::abs(low) + std::abs(high));
    return std::floor((high - offset) / period + slack) >= std::ceil((low - offset) / period - slack);
}

Interval powByWholeNumber(const Interval& a, double n) {
    if (n < 0) return Interval::point(1) / powByWholeNumber(a, -n);
    if (n == 0) return Interval::point(1);
    const auto power = [n](double x) { return std::pow(x, n); };
    if (std::fmod(n, 2) == 1) {
        // Roundings change no sign.
        Interval result = rising(a, power);
        if (a.low >= 0) result.low = std::max(result.low, 0.0);
        if (a.high <= 0) result.high = std::min(result.high, 0.0);
        return result;
    }
    const Interval magnitude = abs(a);
    Interval result = rising(magnitude, power);
    result.low = std::max(result.low, 0.0);
    return result;
}

}  // namespace

Interval Interval::point(double value) {
    return std::isnan(value) ? undefined() : Interval{value, value, false};
}

bool Interval::holds(double value) const {
    if (std::isnan(value)) return maybeUndefined;
    return low <= value && value <= high;
}

Interval hull(const Interval& a, const Interval& b) {
    return {std::min(a.low, b.low), std::max(a.high, b.high), a.maybeUndefined || b.maybeUndefined};
}

Interval operator-(const Interval& a) { return {-a.high, -a.low, a.maybeUndefined}; }

Interval operator+(const Interval& a, const Interval& b) {
    if (a.empty() || b.empty()) return Interval::undefined();
    const double low = a.low + b.low, high = a.high + b.high;
    // A sum that is 0 as computed is 0.
    Interval sum{low == 0 ? 0 : down(low), high == 0 ? 0 : up(high), a.maybeUndefined || b.maybeUndefined};
    // Rounding never changes a sign: sums of squares stay in the domain of a root.
    if (a.low >= 0 && b.low >= 0) sum.low = std::max(sum.low, 0.0);
    if (a.high <= 0 && b.high <= 0) sum.high = std::min(sum.high, 0.0);
    return sum;
}

Interval operator-(const Interval& a, const Interval& b) { return a + -b; }

Interval operator*(const Interval& a, const Interval& b) {
    if (a.empty() || b.empty()) return Interval::undefined();
    const std::array products{product(a.low, b.low), product(a.low, b.high), product(a.high, b.low),
                              product(a.high, b.high)};
    const auto [low, high] = std::minmax_element(products.begin(), products.end());
    const bool undefined = a.maybeUndefined || b.maybeUndefined;
    const auto isZero = [](const Interval& i) { return i.low == 0 && i.high == 0; };
    // An end may be infinite because nothing is known; both are, where infinity itself is the value.
    const auto isInfinity = [](const Interval& i) { return i.low == i.high && std::isinf(i.low); };
    if (isZero(a) || isZero(b)) {
        if (isInfinity(a) || isInfinity(b)) return Interval::undefined();
        return {0, 0, undefined};
    }
    // A product of 0 may stand for one that underflowed; only the signs are certain then.
    const bool sameSigns = (a.low >= 0 && b.low >= 0) || (a.high <= 0 && b.high <= 0);
    const bool oppositeSigns = (a.low >= 0 && b.high <= 0) || (a.high <= 0 && b.low >= 0);
    return {sameSigns ? std::max(0.0, down(*low)) : down(*low),
            oppositeSigns ? std::min(0.0, up(*high)) : up(*high), undefined};
}

Interval operator/(const Interval& a, const Interval& b) {
    if (a.empty() || b.empty()) return Interval::undefined();
    if (b.low <= 0 && b.high >= 0) return Interval::unknown();
    return a * Interval{down(1 / b.high), up(1 / b.low), b.maybeUndefined};
}

Interval abs(const Interval& a) {
    if (a.empty() || a.low >= 0) return a;
    if (a.high <= 0) return -a;
    return {0, std::max(-a.low, a.high), a.maybeUndefined};
}

Interval square(const Interval& a) {
    if (a.empty()) return a;
    const Interval m = abs(a);
    return {std::max(0.0, down(m.low * m.low)), up(m.high * m.high), a.maybeUndefined};
}

Interval sqrt(const Interval& a) {
    const Interval part = restrict(a, 0, infinite);
    if (part.empty()) return part;
    return {std::max(0.0, down(std::sqrt(part.low))), up(std::sqrt(part.high)), part.maybeUndefined};
}

Interval exp(const Interval& a) {
    return within(rising(a, [](double x) { return std::exp(x); }), 0, infinite);
}

Interval log(const Interval& a) {
    return rising(restrict(a, 0, infinite), [](double x) { return std::log(x); });
}

Interval log10(const Interval& a) {
    return rising(restrict(a, 0, infinite), [](double x) { return std::log10(x); });
}

/// A sine or cosine of a range that says nothing about it. Infinity, which all numbers beyond the largest
/// become, has none.
static Interval anyWave(const Interval& a) {
    constexpr double largest = std::numeric_limits<double>::max();
    return {-1, 1, a.maybeUndefined || a.low >= largest || a.high <= -largest};
}

Interval sin(const Interval& a) {
    if (a.empty()) return a;
    constexpr double period = 2 * std::numbers::pi;
    if (!(a.width() < period) || std::max(std::abs(a.low), std::abs(a.high)) > 1e9) return anyWave(a);
    const double first = std::sin(a.low), second = std::sin(a.high);
    const bool top = mayHold(a.low, a.high, period / 4, period);
    const bool bottom = mayHold(a.low, a.high, -period / 4, period);
    const Interval result{bottom ? -1 : libraryDown(std::min(first, second)),
                          top ? 1 : libraryUp(std::max(first, second)), a.maybeUndefined};
    return within(result, -1, 1);
}

Interval cos(const Interval& a) {
    if (a.empty()) return a;
    constexpr double period = 2 * std::numbers::pi;
    if (!(a.width() < period) || std::max(std::abs(a.low), std::abs(a.high)) > 1e9) return anyWave(a);
    const double first = std::cos(a.low), second = std::cos(a.high);
    const bool top = mayHold(a.low, a.high, 0, period);
    const bool bottom = mayHold(a.low, a.high, period / 2, period);
    const Interval result{bottom ? -1 : libraryDown(std::min(first, second)),
                          top ? 1 : libraryUp(std::max(first, second)), a.maybeUndefined};
    return within(result, -1, 1);
}

Interval tan(const Interval& a) {
    if (a.empty()) return a;
    constexpr double period = std::numbers::pi;
    const bool narrow = a.width() < period && std::max(std::abs(a.low), std::abs(a.high)) < 1e9;
    if (!narrow || mayHold(a.low, a.high, period / 2, period)) return Interval::unknown();
    return rising(a, [](double x) { return std::tan(x); });
}

Interval asin(const Interval& a) {
    return rising(restrict(a, -1, 1), [](double x) { return std::asin(x); });
}

Interval acos(const Interval& a) {
    return -rising(restrict(a, -1, 1), [](double x) { return -std::acos(x); });
}

Interval atan(const Interval& a) {
    return rising(a, [](double x) { return std::atan(x); });
}

Interval sinh(const Interval& a) {
    return rising(a, [](double x) { return std::sinh(x); });
}

Interval cosh(const Interval& a) {
    return within(rising(abs(a), [](double x) { return std::cosh(x); }), 1, infinite);
}

Interval tanh(const Interval& a) {
    return within(rising(a, [](double x) { return std::tanh(x); }), -1, 1);
}

Interval asinh(const Interval& a) {
    return rising(a, [](double x) { return std::asinh(x); });
}

Interval acosh(const Interval& a) {
    return rising(restrict(a, 1, infinite), [](double x) { return std::acosh(x); });
}

Interval atanh(const Interval& a) {
    return rising(restrict(a, -1, 1), [](double x) { return std::atanh(x); });
}

Interval floor(const Interval& a) {
    if (a.empty()) return a;
    return {std::floor(a.low), std::floor(a.high), a.maybeUndefined};
}

Interval ceil(const Interval& a) {
    if (a.empty()) return a;
    return {std::ceil(a.low), std::ceil(a.high), a.maybeUndefined};
}

Interval pow(const Interval& base, const Interval& exponent) {
    // pow(NaN, 0) and pow(1, NaN) are 1: an undefined operand does not make the power undefined for sure.
    if (base.empty() || exponent.empty()) return Interval::unknown();
    const bool whole =
        exponent.isPoint() && std::floor(exponent.low) == exponent.low && std::isfinite(exponent.low);
    if (whole) return powByWholeNumber(base, exponent.low);
    if (base.low > 0) return exp(exponent * log(base));
    // Infinite exponents have powers of negative bases, 0 or infinity, and so has the base that numbers too
    // large become.
    if (base.low < 0 && (std::isinf(exponent.low) || std::isinf(base.low))) return Interval::unknown();
    // Other negative bases have powers for whole exponents only.
    if (base.high < 0 && exponent.isPoint()) return Interval::undefined();
    if (!(exponent.low > 0) || (base.low < 0 && !exponent.isPoint())) return Interval::unknown();
    const Interval part = restrict(base, 0, infinite);
    if (part.empty()) return part;
    const double top = std::max(std::pow(part.high, exponent.low), std::pow(part.high, exponent.high));
    const bool undefined = part.maybeUndefined || exponent.maybeUndefined;
    return {0, libraryUp(top), undefined};
}

Interval atan2(const Interval& ordinate, const Interval& abscissa) {
    if (ordinate.empty() || abscissa.empty()) return Interval::undefined();
    const bool undefined = ordinate.maybeUndefined || abscissa.maybeUndefined;
    const double turn = libraryUp(std::numbers::pi);
    // Across the cut on the negative abscissa, and around the origin, every angle is possible.
    if (abscissa.low <= 0 && ordinate.low <= 0 && ordinate.high >= 0) return {-turn, turn, undefined};
    double low = infinite, high = -infinite;
    for (const double y : {ordinate.low, ordinate.high})
        for (const double x : {abscissa.low, abscissa.high}) {
            const double angle = std::atan2(y, x);
            low = std::min(low, angle);
            high = std::max(high, angle);
        }
    return {libraryDown(low), libraryUp(high), undefined};
}

Interval mod(const Interval& a, const Interval& b) {
    if (a.empty() || b.empty()) return Interval::undefined();
    const bool undefined = a.maybeUndefined || b.maybeUndefined || std::isinf(a.low) || std::isinf(a.high);
    if (b.low <= 0 && b.high >= 0) return {std::min(0.0, a.low), std::max(0.0, a.high), true};
    const Interval divisor = abs(b);
    if (b.isPoint() && !std::isinf(a.low) && !std::isinf(a.high)) {
        // fmod is exact, so between two jumps its ends are the ends of the result.
        const double first = std::trunc(a.low / b.low), second = std::trunc(a.high / b.low);
        const double slack = 1e-15 * (std::abs(first) + std::abs(second)) + 1e-15;
        const bool sure = std::abs(first) < 1e15 && std::trunc(a.low / b.low - slack) == first &&
                          std::trunc(a.low / b.low + slack) == first &&
                          std::trunc(a.high / b.low - slack) == first &&
                          std::trunc(a.high / b.low + slack) == first && first == second;
        if (sure) return {std::fmod(a.low, b.low), std::fmod(a.high, b.low), undefined};
    }
    return {a.low >= 0 ? 0 : std::max(a.low, -divisor.high), a.high <= 0 ? 0 : std::min(a.high, divisor.high),
            undefined};
}

}  // namespace isoscope
