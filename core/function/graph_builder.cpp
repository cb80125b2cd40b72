// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/function/graph_builder.h"

#include <cassert>

namespace isoscope {

Expression apply(Operation operation, Expression a) {
    return {a.graph(), a.graph().unary(operation, a.node())};
}

Expression apply(Operation operation, Expression a, Expression b) {
    assert(&a.graph() == &b.graph());
    return {a.graph(), a.graph().binary(operation, a.node(), b.node())};
}

Expression operator+(Expression a, Expression b) { return apply(Operation::add, a, b); }
Expression operator-(Expression a, Expression b) { return apply(Operation::subtract, a, b); }
Expression operator*(Expression a, Expression b) { return apply(Operation::multiply, a, b); }
Expression operator/(Expression a, Expression b) { return apply(Operation::divide, a, b); }
Expression operator-(Expression a) { return apply(Operation::negate, a); }
Expression operator+(Expression a, double b) { return a + a.number(b); }
Expression operator-(Expression a, double b) { return a - a.number(b); }
Expression operator*(Expression a, double b) { return a * a.number(b); }
Expression operator/(Expression a, double b) { return a / a.number(b); }
Expression operator+(double a, Expression b) { return b.number(a) + b; }
Expression operator-(double a, Expression b) { return b.number(a) - b; }
Expression operator*(double a, Expression b) { return b.number(a) * b; }
Expression operator/(double a, Expression b) { return b.number(a) / b; }

Expression sq(Expression a) { return apply(Operation::square, a); }
Expression sqrt(Expression a) { return apply(Operation::squareRoot, a); }
Expression exp(Expression a) { return apply(Operation::exponential, a); }
Expression sin(Expression a) { return apply(Operation::sine, a); }
Expression cos(Expression a) { return apply(Operation::cosine, a); }
Expression abs(Expression a) { return apply(Operation::absolute, a); }
Expression floor(Expression a) { return apply(Operation::floor, a); }
Expression atan2(Expression ordinate, Expression abscissa) {
    return apply(Operation::arcTangent2, ordinate, abscissa);
}
Expression pow(Expression base, Expression exponent) { return apply(Operation::power, base, exponent); }
Expression mod(Expression a, Expression b) { return apply(Operation::remainder, a, b); }
Expression min(Expression a, Expression b) { return apply(Operation::minimum, a, b); }
Expression max(Expression a, Expression b) { return apply(Operation::maximum, a, b); }
Expression min(Expression a, double b) { return min(a, a.number(b)); }
Expression max(Expression a, double b) { return max(a, a.number(b)); }
Expression clamp(Expression a, Expression low, Expression high) { return min(max(a, low), high); }
Expression lessThan(Expression a, Expression b) { return apply(Operation::less, a, b); }

Expression powi(Expression base, int exponent) {
    switch (exponent) {
        case 0: return base.number(1);
        case 1: return base;
        case 2: return sq(base);
        case 3: return sq(base) * base;
        case 4: return sq(sq(base));
        case 5: return sq(sq(base)) * base;
        case 6: return sq(sq(base)) * sq(base);
        case 7: return sq(sq(base)) * base * sq(base);
        case 8: return sq(sq(sq(base)));
        default: return pow(base, base.number(exponent));
    }
}

Expression select(Expression a, Expression negative, Expression otherwise) {
    return {a.graph(), a.graph().ternary(Operation::select3, a.node(), negative.node(), otherwise.node())};
}

Expression select(Expression a, Expression negative, Expression zero, Expression positive) {
    return {a.graph(), a.graph().quaternary(Operation::select4, a.node(), negative.node(), zero.node(),
                                            positive.node())};
}

Expression noise(Expression generator, Expression x, Expression y, Expression z) {
    return {x.graph(),
            x.graph().quaternary(Operation::noise, generator.node(), x.node(), y.node(), z.node())};
}

}  // namespace isoscope
