// SPDX-License-Identifier: GPL-3.0-or-later
// Patterns of discrete values: brick, checker, cubic, hexagon, square.
#include "core/function/patterns/pattern_call.h"

namespace isoscope {

namespace {

constexpr double tiny = 1e-10;

Expression fraction(Expression t) { return t - floor(t); }

/// Where a <= b, the first value, else the second.
Expression whereAtMost(Expression a, Expression b, Expression first, Expression second) {
    return select(b - a, second, first);
}

/// A whole, non-negative number modulo another.
Expression wholeModulo(Expression number, double modulus) {
    return number - modulus * floor(number / modulus);
}

Expression brick(const PatternCall& call) {
    const auto& size = call.pattern.brickSize;
    const double mortar = singlePrecision(call.pattern.mortar - 2 * tiny);
    const Expression x = (call.x + (tiny + mortar)) / size[0];
    const Expression y = call.y + (tiny + mortar);
    const Expression z = (call.z + (tiny + mortar)) / size[2];
    const Expression zero = call.number(0), one = call.number(1), half = call.number(0.5);
    const auto row = [&](Expression u, Expression w) {
        const Expression inRow = whereAtMost(fraction(w), call.number(mortar / size[2]), zero, one);
        return whereAtMost(fraction(u), call.number(mortar / size[0]), zero, inRow);
    };
    const Expression rows = whereAtMost(fraction(y / (2 * size[1])), half, row(x, z + 0.5), row(x + 0.5, z));
    return whereAtMost(fraction(y / size[1]), call.number(mortar / size[1]), zero, rows);
}

Expression checker(const PatternCall& call) {
    const Expression sum = floor(call.x + tiny) + floor(call.y + tiny) + floor(call.z + tiny);
    return sum - 2 * floor(sum / 2);
}

/// The cells m = 1 and m = 4, which the slanted sides of the hexagons cross.
Expression slantedCell(Expression x, Expression z, double m, Expression n) {
    const Expression inner = x - m;
    const Expression odd = wholeModulo(m + n, 2);
    const Expression across = select(odd - 0.5, inner, 1 - inner);
    const Expression a = select(across, across, x.number(0.0001), across);
    const Expression below = wholeModulo(2 * n, 3), above = 2 - wholeModulo(n, 3);
    // A side where (z - n) / a is 1, which a of 0 would leave without a value.
    return select((z - n) - a, below, above);
}

/// The decimal constants are part of the definition.
Expression hexagon(const PatternCall& call) {
    const auto reduced = [](Expression t) { return t - 6 * floor(t / 6); };
    const Expression x = reduced(abs(call.x) / 0.5);
    const Expression z = reduced(select(call.z, 5.196152424 + call.z, call.z) / 0.866025404);
    const Expression n = floor(z);
    const Expression outer = floor(wholeModulo(n + 1, 6) / 2);
    const Expression middle = wholeModulo(floor(n / 2) + 2, 3);
    const Expression right = select(x - 4, middle, select(x - 5, slantedCell(x, z, 4, n), outer));
    return select(x - 1, outer, select(x - 2, slantedCell(x, z, 1, n), right));
}

/// The side of a cube around the origin that a point is seen through: +x, +y, +z, -x, -y, -z are 0 to 5.
/// Measured on POV-Ray 3.7.
Expression cubic(const PatternCall& call) {
    const auto& [pattern, x, y, z, generator] = call;
    const auto side = [](Expression t, double positive) {
        return select(t, t.number(positive + 3), t.number(positive));
    };
    const Expression yOrZ = whereAtMost(abs(z), abs(y), side(y, 1), side(z, 2));
    return whereAtMost(max(abs(y), abs(z)), abs(x), side(x, 0), yOrZ);
}

/// Squares of the xz plane in four colours, counted about a corner. Measured on POV-Ray 3.7.
Expression square(const PatternCall& call) {
    const auto odd = [](Expression t) { return floor(t) - 2 * floor(floor(t) / 2); };
    const Expression x = odd(call.x), z = odd(call.z);
    return select(x - 0.5, z, 3 - z);
}

}  // namespace

Expression tilePattern(const PatternCall& call) {
    switch (call.pattern.kind) {
        case PatternKind::brick: return brick(call);
        case PatternKind::checker: return checker(call);
        case PatternKind::cubic: return cubic(call);
        case PatternKind::square: return square(call);
        default: return hexagon(call);
    }
}

}  // namespace isoscope
