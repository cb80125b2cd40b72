// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/cells/backward_bounds.h"

#include <algorithm>

namespace isoscope {

namespace {

constexpr double infinite = Interval::infinite;

/// All numbers of that size and less.
Interval around(double size) { return {-size, size}; }

}  // namespace

BackwardBounds::Box BackwardBounds::where(const SimplifiedTape& tape, const Interval& wanted,
                                          const LineRegion& region) {
    const auto arguments = static_cast<std::size_t>(tape_.argumentCount());
    const std::size_t count = tape.instructions.size();
    values_.assign(arguments + count, Interval::point(0));
    isUsed_.assign(arguments + count, false);
    isTight_ = true;
    for (std::size_t axis = 0; axis < std::min<std::size_t>(arguments, 3); ++axis)
        values_[axis] = {region.low[static_cast<int>(axis)], region.high[static_cast<int>(axis)]};
    for (std::size_t i = 0; i < count; ++i) values_[arguments + i] = goForward(tape, i);
    narrow(tape.resultValue, wanted);
    for (std::size_t i = count; i-- > 0;) goBack(tape, i);
    Box box{region, isTight_};
    for (std::size_t axis = 0; axis < std::min<std::size_t>(arguments, 3); ++axis) {
        box.region.low[static_cast<int>(axis)] = values_[axis].low;
        box.region.high[static_cast<int>(axis)] = values_[axis].high;
    }
    return box;
}

/// Of an argument or an instruction.
std::size_t BackwardBounds::placeOf(Value value) const {
    return SimplifiedTape::isFixed(value) ? value - SimplifiedTape::fixed
                                          : static_cast<std::size_t>(tape_.argumentCount()) + value;
}

/// Whether it is the same everywhere.
bool BackwardBounds::isUniform(Value value) const {
    return SimplifiedTape::isFixed(value) && tape_.isUniform(value - SimplifiedTape::fixed);
}

Interval BackwardBounds::valueOf(Value value) const {
    if (isUniform(value)) return Interval::point(uniforms_.of(tape_, value - SimplifiedTape::fixed));
    return values_[placeOf(value)];
}

void BackwardBounds::narrow(Value value, const Interval& to) {
    if (isUniform(value)) return;
    Interval& values = values_[placeOf(value)];
    values.low = std::max(values.low, to.low);
    values.high = std::min(values.high, to.high);
}

void BackwardBounds::use(Value value) {
    if (isUniform(value)) return;
    isTight_ &= !isUsed_[placeOf(value)];
    isUsed_[placeOf(value)] = true;
}

Interval BackwardBounds::goForward(const SimplifiedTape& tape, std::size_t instruction) {
    const Instruction& at = tape.instructions[instruction];
    const auto& operands = tape.links[instruction].operands;
    for (std::size_t k = 0; k < at.operandCount; ++k) use(operands[k]);
    const Interval a = valueOf(operands[0]);
    const auto b = [&] { return valueOf(operands[1]); };
    switch (at.operation) {
        case Operation::negate: return -a;
        case Operation::absolute: return abs(a);
        case Operation::square: return square(a);
        case Operation::squareRoot: return sqrt(a);
        case Operation::exponential: return exp(a);
        case Operation::naturalLogarithm: return log(a);
        case Operation::add: return a + b();
        case Operation::subtract: return a - b();
        case Operation::multiply: return a * b();
        case Operation::divide: return a / b();
        case Operation::power: return pow(a, b());
        // Which operand it is remains open.
        case Operation::minimum:
            isTight_ = false;
            return {std::min(a.low, b().low), std::min(a.high, b().high)};
        case Operation::maximum:
            isTight_ = false;
            return {std::max(a.low, b().low), std::max(a.high, b().high)};
        default: isTight_ = false; return Interval::all();
    }
}

/// Narrows the operands to those for which the instruction has its value.
void BackwardBounds::goBack(const SimplifiedTape& tape, std::size_t instruction) {
    const Instruction& at = tape.instructions[instruction];
    const auto [p, q, unused, unusedToo] = tape.links[instruction].operands;
    const Interval value = values_[static_cast<std::size_t>(tape_.argumentCount()) + instruction];
    if (value.empty()) return narrow(p, value);
    switch (at.operation) {
        case Operation::negate: return narrow(p, -value);
        case Operation::absolute: return narrow(p, around(value.high));
        case Operation::square: return narrow(p, around(sqrt(value).high));
        case Operation::squareRoot: return narrow(p, {-infinite, square(value).high});
        case Operation::exponential: return narrow(p, log(value));
        case Operation::naturalLogarithm: return narrow(p, exp(value));
        case Operation::add: narrow(p, value - valueOf(q)); return narrow(q, value - valueOf(p));
        case Operation::subtract: narrow(p, value + valueOf(q)); return narrow(q, valueOf(p) - value);
        case Operation::multiply: narrow(p, value / valueOf(q)); return narrow(q, value / valueOf(p));
        case Operation::divide: narrow(p, value * valueOf(q)); return narrow(q, valueOf(p) / value);
        case Operation::minimum: narrow(p, {value.low, infinite}); return narrow(q, {value.low, infinite});
        case Operation::maximum:
            narrow(p, {-infinite, value.high});
            return narrow(q, {-infinite, value.high});
        case Operation::power: {
            const Interval exponent = valueOf(q);
            if (!exponent.isPoint() || !(exponent.low > 0)) return;
            return narrow(p,
                          around(pow(Interval::point(abs(value).high), Interval::point(1) / exponent).high));
        }
        default: return;
    }
}

}  // namespace isoscope
