// SPDX-License-Identifier: GPL-3.0-or-later
// Patterns of plain geometry, cells and crackle.
#include <cmath>

#include "core/function/builtins/formula_blocks.h"
#include "core/function/patterns/pattern_call.h"

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
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (v[axis] == 0) continue;
        const double share = v[axis] / size;
        const Expression term = share == 1 ? coordinates[axis] : share * coordinates[axis];
        t = empty ? term : t + term;
        empty = false;
    }
    return select(1 - t, mod(t, t.number(1)), t);
}

Expression leopard(const PatternCall& call) { return sq((sin(call.x) + sin(call.y) + sin(call.z)) / 3); }

/// A rounded cushion in every unit cube: a cubic curve of the distance from the middle, from 0 with the
/// slopes of the controls to its value at distance 1, times the distances along the axes. Measured on
/// POV-Ray 3.7.
Expression quilted(const PatternCall& call) {
    const auto fromMiddle = [](Expression t) { return t - floor(t) - 0.5; };
    const Expression x = fromMiddle(call.x), y = fromMiddle(call.y), z = fromMiddle(call.z);
    const Expression r = length(x, y, z), rest = 1 - r;
    const double control0 = singlePrecision(call.pattern.control0),
                 control1 = singlePrecision(call.pattern.control1);
    const Expression curve = 3 * control0 * r * sq(rest) + 3 * control1 * sq(r) * rest + powi(r, 3);
    // 1/sqrt(3) to nine digits, as the values show.
    constexpr double scale = 2.0 / 3 * 0.577350269;
    return curve * (abs(x) + abs(y) + abs(z)) * scale;
}

Expression crackle(const PatternCall& call) {
    CrackleSettings settings = call.pattern.crackle;
    settings.noiseGenerator = call.generator;
    settings.cells = call.pattern.kind == PatternKind::cells;
    FunctionGraph& graph = call.x.graph();
    // Where a cell ends is known to all evaluators by the steps of floor.
    const auto place = [&](const Expression& t) { return settings.cells ? floor(t).node() : t.node(); };
    return {graph, graph.crackle(settings, place(call.x), place(call.y), place(call.z))};
}

}  // namespace

Expression shapePattern(const PatternCall& call) {
    const auto& [pattern, x, y, z, generator] = call;
    switch (pattern.kind) {
        case PatternKind::boxed: return falling(max(max(abs(x), abs(y)), abs(z)));
        case PatternKind::cells:
        case PatternKind::crackle: return crackle(call);
        case PatternKind::cylindrical: return falling(length(x, z));
        case PatternKind::gradient: return gradient(call);
        case PatternKind::leopard: return leopard(call);
        case PatternKind::onion: return mod(length(x, y, z), x.number(1));
        case PatternKind::planar: return falling(abs(y));
        case PatternKind::quilted: return quilted(call);
        default: return falling(length(x, y, z));
    }
}

}  // namespace isoscope
