// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace isoscope {

/// A closed range of real numbers for the inner loops of differentiation: everything is inline, and ends are
/// moved outwards by a relative 2^-52 instead of being rounded by a library call. Ends that are not finite
/// mean that nothing is known; check isFinite() after a chain of operations, NaN included.
struct SlopeRange {
    double low = 0;
    double high = 0;

    /// [-size, size], for `size` >= 0; infinity means that nothing is known.
    static SlopeRange within(double size) { return {-size, size}; }
    /// Whether the range is known: false for an end that is infinite or NaN.
    bool isFinite() const {
        constexpr double largest = std::numeric_limits<double>::max();
        return low >= -largest && high <= largest;
    }
    /// The largest magnitude.
    double size() const { return std::max(-low, high); }
    /// Whether it holds 0 alone: a slope that is exactly none.
    bool isZero() const { return low == 0 && high == 0; }
    /// The smallest magnitude.
    double gap() const { return low > 0 ? low : high < 0 ? -high : 0; }
};

/// Added for results that underflow: far above the error, so that products of it stay fast normal numbers.
constexpr double outwards = 0x1p-500;

/// The next steps outwards: more than the error of one rounding to nearest.
inline double lowered(double a) { return a - (std::abs(a) * 0x1p-52 + outwards); }
inline double raised(double a) { return a + (std::abs(a) * 0x1p-52 + outwards); }

inline SlopeRange operator-(const SlopeRange& a) { return {-a.high, -a.low}; }
/// Sums that underflow are exact.
inline SlopeRange operator+(const SlopeRange& a, const SlopeRange& b) {
    const double low = a.low + b.low, high = a.high + b.high;
    return {low - std::abs(low) * 0x1p-52, high + std::abs(high) * 0x1p-52};
}
inline SlopeRange operator-(const SlopeRange& a, const SlopeRange& b) { return a + -b; }
/// Nothing times what is finite is exactly nothing.
inline SlopeRange operator*(const SlopeRange& a, const SlopeRange& b) {
    if ((a.isZero() && b.isFinite()) || (b.isZero() && a.isFinite())) return {};
    const double p = a.low * b.low, q = a.low * b.high, r = a.high * b.low, s = a.high * b.high;
    return {lowered(std::min(std::min(p, q), std::min(r, s))),
            raised(std::max(std::max(p, q), std::max(r, s)))};
}
inline SlopeRange operator*(double c, const SlopeRange& a) {
    if (a.isZero() && std::isfinite(c)) return {};
    return c < 0 ? SlopeRange{lowered(c * a.high), raised(c * a.low)}
                 : SlopeRange{lowered(c * a.low), raised(c * a.high)};
}
/// Tighter than a * a: never below 0.
inline SlopeRange square(const SlopeRange& a) {
    const double least = a.gap(), most = a.size();
    return {std::max(0.0, lowered(least * least)), raised(most * most)};
}
/// The smallest range around both, exact: nothing is moved outwards.
inline SlopeRange hull(const SlopeRange& a, const SlopeRange& b) {
    return {std::min(a.low, b.low), std::max(a.high, b.high)};
}
/// The numbers in both; both are known to hold the number in question.
inline SlopeRange meet(const SlopeRange& a, const SlopeRange& b) {
    return {std::max(a.low, b.low), std::min(a.high, b.high)};
}

/// An upper bound of the root; 0 for negative numbers, infinity for a NaN: a bound that overflowed.
inline double rootAbove(double a) {
    if (a <= 0) return 0;
    return a > 0 ? raised(std::sqrt(raised(a))) : std::numeric_limits<double>::infinity();
}
/// A lower bound of the root.
inline double rootBelow(double a) {
    return a > 0 ? std::max(0.0, lowered(std::sqrt(std::max(0.0, lowered(a))))) : 0;
}

}  // namespace isoscope
