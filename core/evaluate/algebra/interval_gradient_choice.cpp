// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "core/evaluate/algebra/interval_gradient_rules.h"
#include "core/evaluate/interval_evaluator.h"

namespace isoscope::gradient_rules {

namespace {

/// Whether the choice may follow a NaN, which is a jump.
bool mayJump(const IntervalGradient& a, const IntervalGradient& b) {
    return a.value.maybeUndefined || b.value.maybeUndefined;
}

Interval valueOf(Operation operation, const IntervalGradient& a, const IntervalGradient& b) {
    const Interval values[] = {a.value, b.value};
    return isoscope::evaluateOperation(operation, values);
}

bool isSelect(Operation operation) {
    return operation == Operation::select3 || operation == Operation::select4;
}

ChosenSide chosenSideOf(Operation select, const IntervalGradient& condition) {
    const Interval& value = condition.value;
    if (condition.wrap != 0 || !value.isDefined()) return ChosenSide::open;
    if (value.high < 0) return ChosenSide::first;
    const bool isOther = value.low > 0 || (value.low == 0 && select == Operation::select3);
    return isOther ? ChosenSide::second : ChosenSide::open;
}

IntervalGradient extremum(Operation operation, const IntervalGradient& a, const IntervalGradient& b) {
    const bool isMinimum = operation == Operation::minimum;
    // What POV-Ray takes when a side is undefined.
    if (a.value.empty() || b.value.empty()) return isMinimum ? b : a;
    const IntervalGradient& lower = a.value.high <= b.value.low ? a : b;
    const IntervalGradient& upper = &lower == &a ? b : a;
    if (!mayJump(a, b) && lower.value.high <= upper.value.low) return isMinimum ? lower : upper;
    IntervalGradient result = either(a, b, valueOf(operation, a, b));
    if (mayJump(a, b)) result.hazard = worse(result.hazard, GradientHazard::jump);
    return result;
}

}  // namespace

bool isOpenChoice(Operation operation, Operands operands) {
    const Interval& a = operands[0]->value;
    if (operation == Operation::absolute) return a.low < 0 && a.high > 0;
    if (operation != Operation::minimum && operation != Operation::maximum) return false;
    const Interval& b = operands[1]->value;
    return !a.empty() && !b.empty() &&
           (mayJump(*operands[0], *operands[1]) || (a.high > b.low && b.high > a.low));
}

bool isOpenSelect(Operation operation, Operands operands) {
    const auto hasCut = [](const IntervalGradient* operand) { return operand->wrap != 0; };
    return isSelect(operation) && operands[0]->value.isDefined() && std::ranges::none_of(operands, hasCut) &&
           chosenSideOf(operation, *operands[0]) == ChosenSide::open;
}

ChosenSide chosenSide(Operation operation, Operands operands) {
    const IntervalGradient& a = *operands[0];
    if (isSelect(operation)) return chosenSideOf(operation, a);
    if (a.wrap != 0 || a.value.empty() || a.value.maybeUndefined) return ChosenSide::open;
    if (operation == Operation::absolute) {
        if (a.value.low >= 0) return ChosenSide::first;
        return a.value.high <= 0 ? ChosenSide::second : ChosenSide::open;
    }
    if (operation != Operation::minimum && operation != Operation::maximum) return ChosenSide::open;
    const IntervalGradient& b = *operands[1];
    if (b.wrap != 0 || b.value.empty() || b.value.maybeUndefined) return ChosenSide::open;
    const bool isMinimum = operation == Operation::minimum;
    if (a.value.high <= b.value.low) return isMinimum ? ChosenSide::first : ChosenSide::second;
    if (b.value.high <= a.value.low) return isMinimum ? ChosenSide::second : ChosenSide::first;
    return ChosenSide::open;
}

IntervalGradient openChoice(Operation operation, Operands operands) {
    const IntervalGradient& a = *operands[0];
    if (operation == Operation::absolute) return magnitudeOf(a);
    if (!isSelect(operation)) return either(a, *operands[1], valueOf(operation, a, *operands[1]));
    const IntervalGradient& negative = *operands[1];
    const IntervalGradient& other = *operands.back();
    IntervalGradient result = either(negative, other, hull(negative.value, other.value));
    result.axes |= a.axes;
    return result;
}

IntervalGradient takenSide(Operation operation, Operands operands, bool second) {
    if (operation == Operation::absolute) return second ? scaled(*operands[0], -1) : *operands[0];
    if (isSelect(operation)) return *operands[second ? operands.size() - 1 : 1];
    return *operands[second ? 1 : 0];
}

IntervalGradient possibleSide(Operation operation, Operands operands, bool second) {
    IntervalGradient side = takenSide(operation, operands, second);
    side.smooth = side.root.smooth = false;
    // The values behind a pending wrap are not those of the range.
    if (std::ranges::any_of(operands, [](const IntervalGradient* u) { return u->wrap != 0; })) return side;
    if (operation == Operation::absolute) {
        side.value.low = std::max(side.value.low, 0.0);
    } else if (!isSelect(operation) && !mayJump(*operands[0], *operands[1])) {
        const Interval& other = operands[second ? 0 : 1]->value;
        if (operation == Operation::minimum)
            side.value.high = std::min(side.value.high, other.high);
        else
            side.value.low = std::max(side.value.low, other.low);
    }
    return side.value.empty() ? undefinedEverywhere() : side;
}

IntervalGradient marginOf(Operation operation, Operands operands, bool second) {
    const IntervalGradient a = resolveWrap(*operands[0]);
    const bool isOwn = operation == Operation::absolute || isSelect(operation);
    const IntervalGradient b = resolveWrap(*operands[isOwn ? 0 : 1]);
    const IntervalGradient unknown = hazardous(Interval::unknown(), a.axes | b.axes, GradientHazard::unknown);
    if (mayJump(a, b)) return unknown;
    if (operation == Operation::absolute) return second ? scaled(a, -1) : a;
    if (isSelect(operation)) return second ? a : scaled(a, -1);
    const IntervalGradient difference = sum(b, scaled(a, -1));
    // Both are infinite: nothing is excluded.
    if (difference.value.empty()) return unknown;
    return (operation == Operation::minimum) != second ? difference : scaled(difference, -1);
}

double cornerOf(const IntervalGradient& u) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN(), close = 1e-6, farthest = 1e9;
    if (u.isConstant() || u.value.empty() || (u.wrap != 0 && !isWhole(u.wrap, 1))) return none;
    if (!(std::max(std::abs(u.value.low), std::abs(u.value.high)) < farthest)) return none;
    const double corner = std::ceil(2 * u.value.low) / 2;
    // Not so wide that a place in the box could be taken for one a period away.
    const bool within = u.value.low < corner && u.value.high > corner && u.value.low > corner - 0.5 + close &&
                        u.value.high < corner + 0.5 - close;
    return within ? corner : none;
}

IntervalGradient fromCorner(const IntervalGradient& operand, double corner) {
    const IntervalGradient u = withoutCut(operand);
    const double middle = 0.5 * u.value.low + 0.5 * u.value.high, periods = std::round(corner - middle);
    return scaled(sum(u, constant(Interval::point(periods) - Interval::point(corner))), 2);
}

IntervalGradient aboutCorner(const IntervalGradient& magnitude, double corner) {
    const bool isTop = corner != std::floor(corner);
    return isTop ? sum(scaled(magnitude, -1), constant(Interval::point(1))) : magnitude;
}

IntervalGradient minimumOf(const IntervalGradient& a, const IntervalGradient& b) {
    return extremum(Operation::minimum, a, b);
}

IntervalGradient maximumOf(const IntervalGradient& a, const IntervalGradient& b) {
    return extremum(Operation::maximum, a, b);
}

IntervalGradient remainderOf(const IntervalGradient& a, const IntervalGradient& b) {
    if (b.wrap != 0) return remainderOf(a, resolveWrap(b));
    if (a.wrap != 0) {
        // It repeats itself while the dividend keeps its sign.
        const Interval after = afterWrap(a).value;
        const bool keepsSign =
            std::min(after.low, a.value.low) >= 0 || std::max(after.high, a.value.high) <= 0;
        if (keepsSign && b.isConstant() && b.value.isPoint() && isWhole(a.wrap, b.value.low))
            return remainderOf(withoutCut(a), b);
        return acrossCut(a, false, [&](const IntervalGradient& u) { return remainderOf(u, b); });
    }
    const Interval value = mod(a.value, b.value);
    const std::uint8_t axes = a.axes | b.axes;
    if (axes == 0) return constant(value);
    if (value.empty()) return undefinedEverywhere();
    const Interval ratio = a.value / b.value;
    const double first = std::trunc(ratio.low), last = std::trunc(ratio.high);
    if (first == last && std::abs(first) < 1e15 && !ratio.maybeUndefined) {
        // Nothing times a divisor that may be infinite is nothing.
        IntervalGradient result = first == 0 ? a : sum(a, scaled(b, -first));
        if (result.hazard <= GradientHazard::jump &&
            !(value.low > result.value.high || value.high < result.value.low))
            result.value = {std::max(value.low, result.value.low), std::min(value.high, result.value.high),
                            value.maybeUndefined};
        return result;
    }
    if (b.value.low <= 0 && b.value.high >= 0) return hazardous(value, axes, GradientHazard::pole);
    if (!b.isConstant() || std::isinf(ratio.low) || std::isinf(ratio.high))
        return hazardous(value, axes, GradientHazard::unknown);
    // Between its jumps it climbs as `a` does.
    IntervalGradient result = a;
    result.value = value;
    result.hazard = worse(a.hazard, GradientHazard::jump);
    result.smooth = false;
    result.rootExponent = 0;
    result.sumsExponentials = false;
    result.angleSteepness = 0;
    result.origin = 0;
    if (last - first != 1 || !b.value.isPoint() || !(b.value.low > 0) || !a.bounded() || ratio.maybeUndefined)
        return result;
    // One jump alone: the values below it, continued, or those minus the divisor.
    const IntervalGradient continued = sum(a, constant(Interval::point(-first) * b.value));
    if (!continued.bounded()) return result;
    result = continued;
    result.wrap = b.value.low;
    result.cutAt = first >= 0 ? b.value.low : 0;
    return result;
}

IntervalGradient selectOf(Operands operands) {
    const Interval& choice = operands[0]->value;
    const bool defined = !choice.maybeUndefined;
    const IntervalGradient& negative = *operands[1];
    const IntervalGradient& positive = *operands[operands.size() - 1];
    if (operands.size() == 3) {
        if (choice.empty() || choice.low >= 0) return positive;
    } else {
        if (choice.empty() || choice.low > 0) return positive;
        if (defined && choice.low == 0 && choice.high == 0) return *operands[2];
    }
    if (defined && choice.high < 0) return negative;
    // A value that is replaced by a constant where it is 0, and nowhere else: what does not see the
    // difference has no jump.
    const bool replaced = operands.size() == 4 && operands[0] == operands[1] && operands[0] == operands[3];
    if (replaced && operands[2]->isConstant() && operands[2]->value.isPoint() && operands[0]->bounded() &&
        defined) {
        IntervalGradient result = positive;
        result.rootExponent = 0;
        result.sumsExponentials = false;
        result.origin = 0;
        result.wrap = -operands[2]->value.low;
        result.cutAt = std::numeric_limits<double>::quiet_NaN();
        return result;
    }
    Interval value = hull(negative.value, positive.value);
    IntervalGradient result = either(negative, positive, value);
    if (operands.size() == 4 && choice.low <= 0 && choice.high >= 0)
        result = either(result, *operands[2], hull(value, operands[2]->value));
    result.axes |= operands[0]->axes;
    // The branches may agree where they meet; nothing here knows.
    result.hazard = worse(result.hazard, GradientHazard::jump);
    result.smooth = false;
    result.rootExponent = 0;
    result.sumsExponentials = false;
    return result;
}

IntervalGradient stepped(Operands operands, const Interval& value) {
    if (value.isPoint() || value.empty()) return constant(value);
    std::uint8_t axes = 0;
    for (const IntervalGradient* operand : operands) axes |= operand->axes;
    IntervalGradient result = constant(value);
    result.axes = axes;
    if (axes == 0) return result;
    result.hazard = GradientHazard::jump;
    result.smooth = false;
    return result;
}

IntervalGradient wholeNumberOf(const IntervalGradient& u, const Interval& value) {
    if (value.width() != 1 || value.maybeUndefined || !u.bounded() || u.isConstant())
        return stepped(std::array{&u}, value);
    IntervalGradient result = constant(Interval::point(value.high));
    result.axes = u.axes;
    result.wrap = 1;
    return result;
}

IntervalGradient withCut(IntervalGradient rest, double at) {
    if (rest.wrap == -1) rest.cutAt = at;
    return rest;
}

IntervalGradient fractionOf(const IntervalGradient& u, const Interval& value) {
    IntervalGradient result = withCut(sum(u, scaled(wholeNumberOf(u, floor(u.value)), -1)), 0);
    // Of a pending wrap the value is that before it.
    if (result.wrap == 0) result.value = value;
    return result;
}

}  // namespace isoscope::gradient_rules
