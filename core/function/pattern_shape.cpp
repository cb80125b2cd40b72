// SPDX-License-Identifier: GPL-3.0-or-later
// Patterns of plain geometry, crackle and the Mandelbrot set.
#include <algorithm>
#include <cmath>

#include "core/function/formula_blocks.h"
#include "core/function/pattern_call.h"

namespace isoscope {

namespace {

/// 1 - t, down to 0.
Expression falling(Expression t) { return max(1 - t, 0); }

Expression gradient(const PatternCall& call) {
    const auto& v = call.pattern.gradient;
    const double size = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    const Expression coordinates[] = {call.x, call.y, call.z};
    // A direction without length has no gradient: POV-Ray gives NaN too.
    Expression t = call.number(size > 0 ? 0 : std::nan(""));
    bool empty = size > 0;
    for (int axis = 0; axis < 3; ++axis) {
        if (v[axis] == 0) continue;
        const double share = v[axis] / size;
        const Expression term = share == 1 ? coordinates[axis] : share * coordinates[axis];
        t = empty ? term : t + term;
        empty = false;
    }
    return select(1 - t, mod(t, t.number(1)), t);
}

Expression leopard(const PatternCall& call) { return sq((sin(call.x) + sin(call.y) + sin(call.z)) / 3); }

/// All iterations are unrolled; a point that has escaped takes the number of its step and nothing behind it.
Expression mandelbrot(const PatternCall& call) {
    const int count = std::clamp(call.pattern.iterations, 1, mandelIterationLimit);
    std::vector<Expression> margins;
    Expression re = call.x, im = call.y;
    for (int k = 0; k < count; ++k) {
        const Expression nextRe = sq(re) - sq(im) + call.x;
        im = 2 * re * im + call.y;
        re = nextRe;
        margins.push_back(4 - (sq(re) + sq(im)));
    }
    Expression value = call.number(1);
    for (int k = count; k-- > 0;)
        value = select(margins[k], call.number(static_cast<double>(k) / count), value);
    return value;
}

Expression crackle(const PatternCall& call) {
    CrackleSettings settings = call.pattern.crackle;
    settings.noiseGenerator = call.generator;
    FunctionGraph& graph = call.x.graph();
    return {graph, graph.crackle(settings, call.x.node(), call.y.node(), call.z.node())};
}

}  // namespace

Expression shapePattern(const PatternCall& call) {
    const auto& [pattern, x, y, z, generator] = call;
    switch (pattern.kind) {
        case PatternKind::boxed:
            return falling(max(max(abs(x), abs(y)), abs(z)));
        case PatternKind::crackle:
            return crackle(call);
        case PatternKind::cylindrical:
            return falling(length(x, z));
        case PatternKind::gradient:
            return gradient(call);
        case PatternKind::leopard:
            return leopard(call);
        case PatternKind::mandel:
            return mandelbrot(call);
        case PatternKind::onion:
            return mod(length(x, y, z), x.number(1));
        case PatternKind::planar:
            return falling(abs(y));
        default:
            return falling(length(x, y, z));
    }
}

}  // namespace isoscope
