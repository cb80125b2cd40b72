// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/function/builtins/formula_blocks.h"

#include <numbers>

namespace isoscope {

using std::numbers::pi;

bool isConstant(Expression a) { return a.graph().isConstant(a.node()); }

double constantOr(Expression a, double otherwise) {
    return isConstant(a) ? a.graph().value(a.node()) : otherwise;
}

Expression limited(Expression a, Expression limit) { return min(max(a, -limit), limit); }

Expression limited(Expression a) { return limited(a, a.number(10)); }

Expression lesser(Expression a, Expression b) { return min(b, a); }

Expression length(Expression a, Expression b) { return sqrt(sq(a) + sq(b)); }

Expression length(Expression a, Expression b, Expression c) { return sqrt(sq(a) + sq(b) + sq(c)); }

std::pair<Expression, Expression> latheProfile(Expression x, Expression y, Expression z,
                                               Expression latheSwitch, Expression offset, Expression angle) {
    if (isConstant(latheSwitch) && !(constantOr(latheSwitch, 0) > 0)) return {x, y};
    const Expression radius = length(x, z) - offset;
    Expression u = radius, v = y;
    // For an angle that is not constant, a turn by 0 gives the same up to the sign of a zero.
    if (constantOr(angle, 1) != 0) {
        const Expression theta = angle * pi / 180;
        const Expression c = cos(theta), s = sin(theta);
        u = radius * c - y * s;
        v = radius * s + y * c;
    }
    if (isConstant(latheSwitch)) return {u, v};
    return {select(-latheSwitch, u, x), select(-latheSwitch, v, y)};
}

namespace {

Expression superellipse(Expression type, Expression a, Expression b) {
    // Powers of exponent 1 are exact.
    if (constantOr(type, 0) == 2) return abs(a) + abs(b);
    const Expression exponent = 2 / type;
    return pow(pow(abs(a), exponent) + pow(abs(b), exponent), type / 2);
}

}  // namespace

Expression crossSection(Expression type, Expression a, Expression b) {
    if (constantOr(type, 2) == 1) return length(a, b);
    if (constantOr(type, 2) == 0) return max(abs(a), abs(b));
    const Expression general = superellipse(type, a, b);
    if (isConstant(type)) return general;
    const Expression square = max(abs(a), abs(b));
    return select(type, general, square, select(type - 1, general, length(a, b), general));
}

Expression offAxis(Expression x, Expression z, double replacement) {
    return select(abs(x) + abs(z), x, x.number(replacement), x);
}

Expression wrapped(Expression a, Expression modulus) {
    // The fraction is one jump; a remainder and its sign are two, at places that bounds cannot tell apart.
    if (constantOr(modulus, 0) > 0) {
        const Expression turns = a / modulus;
        return modulus * (turns - floor(turns));
    }
    const Expression remainder = mod(a, modulus);
    return select(remainder, remainder + modulus, remainder);
}

Expression offMiddle(Expression a, Expression modulus) {
    const Expression wave = modulus / 2 * (1 - apply(Operation::triangleWave, a / modulus));
    if (constantOr(modulus, 0) > 0) return wave;
    const Expression stepped = abs(wrapped(a, modulus) - modulus / 2);
    return select(modulus, stepped, stepped, wave);
}

}  // namespace isoscope
