// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "core/numeric/interval.h"
#include "core/numeric/slope_range.h"

namespace isoscope {

/// Why a gradient has no bound on a box, as far as the formulas tell; in order of precedence.
enum class GradientHazard : std::uint8_t {
    none,
    jump,  ///< a value may jump (floor, mod, comparisons, select, the cut of atan2); slopes beside it are
           ///< known
    steepEdge,  ///< an infinite slope where a value ends or has a cusp (sqrt and pow at 0, asin at 1)
    pole,       ///< the function or its slope is infinite (division by 0, ln at 0, tan, atan2 at its axis)
    overflow,   ///< numbers beyond the range of doubles
    unknown,    ///< no bounds exist for the operation
};

/// A function whose magnitude is the root of a sum of powers, over a box: of |u|^e it is u itself, of the sum
/// of two the norm of their roots. Or the logarithm of a sum of exponentials, of exp(u) u itself. Slopes hold
/// wherever it is differentiable.
struct PowerRoot {
    bool known = false;
    bool smooth = false;  ///< twice differentiable in the whole box; `bend` is known
    SlopeRange value;
    std::array<SlopeRange, 3> slope{};
    double steepness = 0;  ///< at least |gradient|; NaN where that is not known
    std::array<SlopeRange, 6> bend{};
};

/// A value over a box with its derivatives in x, y and z. Sound: every value lies in `value`, and wherever
/// the function is differentiable its derivatives lie in the ranges. While `hazard` is none the function is
/// Lipschitz on the box (where it is defined), and `steepness` is a Lipschitz constant.
struct IntervalGradient {
    Interval value;
    std::uint8_t axes = 0;  ///< bit k: depends on coordinate k. Slopes of other axes are 0
    GradientHazard hazard = GradientHazard::none;
    /// Of a coordinate (1 to 3) or one times a constant, its number, with the sign of the constant; else 0.
    std::int8_t origin = 0;
    /// Twice differentiable in the whole box; `bend` is known. When `pieced`, each of the functions is that
    /// the open choices (min, max, abs) of the box can make of it, and slopes and bends are those of all.
    bool smooth = true;
    bool pieced = false;
    /// e, when the value is a sum of magnitudes to the power e, |u1|^e + |u2|^e + ..., e >= 1; else 0.
    double rootExponent = 0;
    /// The true value is `value` or `value - wrap`, and jumps between them somewhere in the box (the cut of
    /// an angle). 0 for everything else. Needs resolving (resolveWrap) before anything but sums and periodic
    /// functions uses the value.
    double wrap = 0;
    /// The value at the jump, which is from this to `wrap` less; NaN where that is not known.
    double cutAt = std::numeric_limits<double>::quiet_NaN();
    /// Of a sine or cosine, or of one times -1: a Lipschitz constant of its angle. 0 for everything else.
    /// With 1 added it is twice the square of another sine, and so a sum of powers.
    double angleSteepness = 0;
    std::array<SlopeRange, 3> slope{};
    double steepness = 0;              ///< at least |gradient|
    std::array<SlopeRange, 6> bend{};  ///< second derivatives xx, xy, xz, yy, yz, zz
    /// Of such a sum s: a Lipschitz constant of its root s^(1/e), which exists even where s is 0.
    double rootSteepness = 0;
    /// For e = 2 also ranges of the matrix that sums up grad(u_i) grad(u_i)^T: sqrt(s) has no gradient longer
    /// than the root of its largest eigenvalue.
    std::array<SlopeRange, 6> rootSpread{};
    /// A sum of exponentials, exp(u1) + exp(u2) + ..., times positive factors, and no sum of powers: `root`
    /// is its logarithm, if known, and rootSteepness a Lipschitz constant of that.
    bool sumsExponentials = false;
    PowerRoot root;  ///< of such a sum

    /// Whether the value depends on no coordinate, whether it is a sum of powers whose root is known
    /// (rootSteepness), and whether the function is Lipschitz on the box with the constant `steepness`.
    bool isConstant() const { return axes == 0; }
    bool isSumOfPowers() const { return rootExponent != 0; }
    bool bounded() const { return hazard == GradientHazard::none; }
};

/// Position of the second derivative in axes i and j.
constexpr std::size_t bendIndex(std::size_t i, std::size_t j) {
    constexpr std::size_t first[3] = {0, 2, 3};
    return i <= j ? first[i] + j : first[j] + i;
}

namespace gradient_rules {

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// The ends alone: `maybeUndefined` is lost, and an empty interval becomes a reversed range.
inline SlopeRange rangeOf(const Interval& a) { return {a.low, a.high}; }

/// A value that depends on no coordinate. An empty one stands for undefinedEverywhere().
IntervalGradient constant(const Interval& value);
/// Undefined in the whole box: no slopes anywhere.
IntervalGradient undefinedEverywhere();
/// The coordinate `axis` (0 to 2) itself over `range`: slope 1 along its axis.
IntervalGradient coordinate(std::size_t axis, const Interval& range);
/// A value whose slopes have no bound along `axes`, for the reason `hazard`: slopes and steepness are
/// infinite.
IntervalGradient hazardous(const Interval& value, std::uint8_t axes, GradientHazard hazard);

/// Upper and lower bound of the length of a vector in these ranges.
double lengthAbove(const std::array<SlopeRange, 3>& vector);
double lengthBelow(const std::array<SlopeRange, 3>& vector);
/// An upper bound of the largest eigenvalue of every positive semidefinite matrix in these ranges.
double eigenvalueAbove(const std::array<SlopeRange, 6>& matrix);

/// Derivatives of a function of one value: `second` is used when finite and the operand is smooth.
struct Derivatives {
    SlopeRange first;
    SlopeRange second = SlopeRange::within(unlimited);
};
/// h(u) with the value `value`; `hazard` says what is wrong where `first` is not finite.
IntervalGradient chain(const IntervalGradient& u, const Interval& value, const Derivatives& h,
                       GradientHazard hazard);
/// Intersects steepness and slopes with what each knows of the other, and turns numbers that are not finite
/// into a hazard.
void settle(IntervalGradient& a);
/// The worse of both.
inline GradientHazard worse(GradientHazard a, GradientHazard b) { return a < b ? b : a; }
/// Makes a pending wrap an ordinary jump.
IntervalGradient resolveWrap(const IntervalGradient& a);
/// Whether a pending wrap jumps from a value to minus that, which even functions do not show.
bool cutsAroundZero(const IntervalGradient& a);
/// The values after a pending wrap, without one.
IntervalGradient afterWrap(const IntervalGradient& a);

/// factor a, a + b and a b, with what a later root can use: sums of powers (IntervalGradient::rootExponent)
/// are recognized. A factor that is not finite makes an overflow.
IntervalGradient scaled(const IntervalGradient& a, double factor);
IntervalGradient sum(const IntervalGradient& a, const IntervalGradient& b);
IntervalGradient product(const IntervalGradient& a, const IntervalGradient& b);
/// What is one or the other at each place of the box; continuous where they meet.
IntervalGradient either(const IntervalGradient& a, const IntervalGradient& b, const Interval& value);

/// function(u) of one value with a pending wrap: what it is on both sides of the cut, with a jump between
/// them unless nothing jumps there for an even function.
template <class Function>
IntervalGradient acrossCut(const IntervalGradient& u, bool isEven, Function function) {
    IntervalGradient before = u;
    before.wrap = 0;
    const IntervalGradient a = resolveWrap(function(before)), b = resolveWrap(function(afterWrap(u)));
    IntervalGradient result = either(a, b, hull(a.value, b.value));
    // Also where each side is the same everywhere.
    result.axes |= u.axes;
    if (!isEven || !cutsAroundZero(u)) result.hazard = worse(result.hazard, GradientHazard::jump);
    // The choice is none of those that pieces are told by.
    result.smooth = false;
    return result;
}

/// h(u, v) for a function of two values with first and second derivatives.
struct TwoDerivatives {
    SlopeRange byFirst, bySecond;
    SlopeRange twiceFirst, mixed, twiceSecond;
};
/// `hazard` says what is wrong where a first derivative is not finite; hazards of u and v worse than a jump
/// are passed on, with `value` alone kept.
IntervalGradient chain(const IntervalGradient& u, const IntervalGradient& v, const Interval& value,
                       const TwoDerivatives& h, GradientHazard hazard);

/// Square with what a root of it can use.
IntervalGradient squareOf(const IntervalGradient& u);
/// sqrt, exact about sums of squares.
IntervalGradient squareRootOf(const IntervalGradient& u);
/// u to a constant power.
IntervalGradient powerOf(const IntervalGradient& u, double exponent);

}  // namespace gradient_rules

}  // namespace isoscope
