// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/evaluate/algebra/interval_gradient.h"
#include "core/function/function_graph.h"

namespace isoscope::gradient_rules {

using Operands = std::span<const IntervalGradient* const>;

/// Whether IntervalGradient::axes holds an axis, 0 to 2.
constexpr bool dependsOn(std::uint8_t axes, std::size_t axis) { return (axes >> axis & 1) != 0; }

/// Calls visit(i, j, index) for the second derivatives that may be other than 0.
template <class Visit>
void forEachBend(std::uint8_t axes, Visit visit) {
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = i; j < 3; ++j)
            if (dependsOn(axes, i) && dependsOn(axes, j)) visit(i, j, bendIndex(i, j));
}

/// The products of the components of a gradient of which nothing but its length is known.
std::array<SlopeRange, 6> spreadWithin(double steepness);
/// A sum of powers as one with a smaller exponent: |u|^6 is (u^3)^2. No sum of powers where that is not
/// finite.
IntervalGradient withRootExponent(const IntervalGradient& s, double exponent);
/// Tells `result`, the sum of two sums of powers with the same exponent, what is known of its root.
void addRoots(const IntervalGradient& s, const IntervalGradient& t, IntervalGradient& result);

/// Exponents that come out of different products are the same but for rounding.
constexpr double sameExponents = 1e-14;

/// What is known of u as the root of |u|^e, of a constant that is not negative as a power, of the root of
/// s times a positive factor, of |root|^e for e > 1, and of the root of the sum of two powers with the same
/// exponent.
PowerRoot rootOf(const IntervalGradient& u);
PowerRoot constantRoot(const Interval& value, double exponent);
PowerRoot scaledRoot(const PowerRoot& root, const Interval& factor, double exponent);
PowerRoot poweredRoot(const PowerRoot& root, double exponent, std::uint8_t axes);
PowerRoot joinedRoot(const PowerRoot& a, const PowerRoot& b, double exponent, std::uint8_t axes);
/// The logarithm of exp(a) + exp(b), and a constant and multiples of sums as logarithms of them.
PowerRoot joinedLogarithm(const PowerRoot& a, const PowerRoot& b, std::uint8_t axes);
PowerRoot constantLogarithm(const Interval& value);
/// factor root + shift.
PowerRoot movedRoot(const PowerRoot& root, double factor, const Interval& shift);
/// Narrows slopes and bends of `result`, the logarithm of `s`, to what is known of that.
void useLogarithm(const IntervalGradient& s, IntervalGradient& result);
/// Tells `result` that it is exp(root), and narrows its slopes and bends to that.
void useExponential(const PowerRoot& root, double steepness, IntervalGradient& result);
/// Narrows slopes and bends of `result` to those of |root|^exponent, for an exponent >= 1; to be settled.
void usePowerOfRoot(const PowerRoot& root, double exponent, IntervalGradient& result);

/// Whether a wrap is none for functions of this period, and the operand of such a function.
bool isWhole(double wrap, double period);
IntervalGradient withoutCut(const IntervalGradient& u);

/// |u|, where u may be 0.
IntervalGradient magnitudeOf(const IntervalGradient& u);
/// Operations of one value, wraps resolved where the operation cannot use them.
IntervalGradient elementary(Operation operation, const IntervalGradient& u);

/// atan2: a box across the cut gives a pending wrap of 2 pi, one that may hold the origin a pole.
IntervalGradient arcTangent2Of(const IntervalGradient& ordinate, const IntervalGradient& abscissa);
/// a / b: a divisor that may be 0 is a pole, one that is 0 everywhere leaves nothing defined.
IntervalGradient quotient(const IntervalGradient& a, const IntervalGradient& b);
/// base^exponent: a constant exponent goes by powerOf(), others as exp(exponent ln(base)), with a steep edge
/// where the base may be 0 or less.
IntervalGradient power(const IntervalGradient& base, const IntervalGradient& exponent);

/// Of a triangle wave over a box with one of its corners: the corner; NaN for other boxes. With the distance
/// from the corner, times 2, the wave is its magnitude or 1 minus that.
double cornerOf(const IntervalGradient& u);
IntervalGradient fromCorner(const IntervalGradient& u, double corner);
/// The wave for what stands for the magnitude.
IntervalGradient aboutCorner(const IntervalGradient& magnitude, double corner);

/// Whether a min, max or abs takes now one side, now the other; its value then; and one of the sides.
bool isOpenChoice(Operation operation, Operands operands);
/// Whether a select does so, which then is a choice as these are if it is known not to jump in between.
bool isOpenSelect(Operation operation, Operands operands);
IntervalGradient openChoice(Operation operation, Operands operands);
/// Which side a min, max, abs or select takes in the whole box, if it is certain.
enum class ChosenSide : std::uint8_t { open, first, second };
ChosenSide chosenSide(Operation operation, Operands operands);
IntervalGradient takenSide(Operation operation, Operands operands, bool second);
/// The same with those values alone that it can have where it is the one that is taken; not smooth, since
/// values beside these places are missing.
IntervalGradient possibleSide(Operation operation, Operands operands, bool second);
/// Below 0 where the other side is taken.
IntervalGradient marginOf(Operation operation, Operands operands, bool second);

/// Operations that take one operand or another, or have steps.
IntervalGradient minimumOf(const IntervalGradient& a, const IntervalGradient& b);
IntervalGradient maximumOf(const IntervalGradient& a, const IntervalGradient& b);
IntervalGradient remainderOf(const IntervalGradient& a, const IntervalGradient& b);
IntervalGradient selectOf(Operands operands);
/// int, div, comparisons: constant, or with a jump.
IntervalGradient stepped(Operands operands, const Interval& value);
/// floor, ceil and int, and the fraction: a single step within the box is a wrap.
IntervalGradient wholeNumberOf(const IntervalGradient& u, const Interval& value);
/// What is left of a value less a whole number near it, which has the value `at` before a step of 1.
IntervalGradient withCut(IntervalGradient rest, double at);
IntervalGradient fractionOf(const IntervalGradient& u, const Interval& value);

/// A function of three places with slopes in `slope` along them, and none of them together longer than
/// `steepness`. `bend`: its second derivatives xx, xy, xz, yy, yz, zz; null where they are not known.
IntervalGradient ofThree(Operands places, const Interval& value, const std::array<SlopeRange, 3>& slope,
                         double steepness, const std::array<SlopeRange, 6>* bend = nullptr);
/// noise and the components of DNoise.
IntervalGradient noiseOf(Operation operation, Operands operands);
/// crackle at three places: by the cell points that may count in the box. A jump where the box may hold
/// places that look at different cells of which it matters; in metrics below 1 a steep edge beside each cell
/// point.
IntervalGradient crackleOf(const CrackleSettings& settings, Operands places, const Interval& value);

}  // namespace isoscope::gradient_rules
