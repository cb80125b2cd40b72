// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

namespace isoscope {

/// A closed interval of real numbers, ends possibly infinite, that encloses all values an expression may
/// take; ends are rounded outwards by every operation. Next to its values an expression may be undefined
/// somewhere (NaN in the evaluators: the root of a negative number, 0/0, also a division by exactly 0):
/// `maybeUndefined` says so, and an empty interval means undefined everywhere.
struct Interval {
    double low = 0;
    double high = 0;
    bool maybeUndefined = false;

    static constexpr double infinite = std::numeric_limits<double>::infinity();

    /// Any real number, but defined everywhere.
    static Interval all() { return {-infinite, infinite, false}; }
    /// Nothing is known, not even whether there is a value.
    static Interval unknown() { return {-infinite, infinite, true}; }
    /// Undefined everywhere.
    static Interval undefined() { return {infinite, -infinite, true}; }
    /// One number; undefined() for NaN.
    static Interval point(double value);

    /// Undefined everywhere; a NaN for an end counts as this, too.
    bool empty() const { return !(low <= high); }
    /// Whether every value is a number.
    bool isDefined() const { return !maybeUndefined && !empty(); }
    /// One value, exactly, and defined everywhere.
    bool isPoint() const { return low == high && !maybeUndefined; }
    /// Whether `value` may be a value of the expression; NaN stands for undefined.
    bool holds(double value) const;
    /// Rounded to nearest, not outwards; negative for an empty interval.
    double width() const { return high - low; }

    friend bool operator==(const Interval&, const Interval&) = default;
};

/// The smallest interval around both.
Interval hull(const Interval& a, const Interval& b);

Interval operator-(const Interval& a);
Interval operator+(const Interval& a, const Interval& b);
Interval operator-(const Interval& a, const Interval& b);
Interval operator*(const Interval& a, const Interval& b);
/// Around a divisor that may be 0 nothing is known.
Interval operator/(const Interval& a, const Interval& b);

/// Around every value of the function on `a`. Operands outside its domain (roots and logarithms of negative
/// numbers, asin beyond 1) set `maybeUndefined`; where all are outside, the result is empty. tan across a
/// pole is unknown().
Interval abs(const Interval& a);
Interval square(const Interval& a);
Interval sqrt(const Interval& a);
Interval exp(const Interval& a);
Interval log(const Interval& a);
Interval log10(const Interval& a);
Interval sin(const Interval& a);
Interval cos(const Interval& a);
Interval tan(const Interval& a);
Interval asin(const Interval& a);
Interval acos(const Interval& a);
Interval atan(const Interval& a);
Interval sinh(const Interval& a);
Interval cosh(const Interval& a);
Interval tanh(const Interval& a);
Interval asinh(const Interval& a);
Interval acosh(const Interval& a);
Interval atanh(const Interval& a);
Interval floor(const Interval& a);
Interval ceil(const Interval& a);
/// A whole exponent allows any base. unknown() for a negative base with an open exponent, for a base that may
/// be 0 with an exponent that may be 0 or less, and for an empty operand (pow(NaN, 0) is 1).
Interval pow(const Interval& base, const Interval& exponent);
/// Arguments as std::atan2: the ordinate first.
Interval atan2(const Interval& ordinate, const Interval& abscissa);
/// fmod: the sign of a.
Interval mod(const Interval& a, const Interval& b);

}  // namespace isoscope
