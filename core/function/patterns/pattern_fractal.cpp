// SPDX-License-Identifier: GPL-3.0-or-later
// The fractal patterns: mandel, julia, and both for the two models of a magnet.
#include <algorithm>
#include <vector>

#include "core/function/builtins/fractal_orbit.h"
#include "core/function/builtins/fractal_table.h"
#include "core/function/patterns/pattern_call.h"

namespace isoscope {

namespace {

using Complex = fractal::Complex<Expression>;

Expression lookedUp(const PatternCall& call) {
    CrackleSettings settings;
    settings.table = std::make_shared<const FractalTable>(call.pattern);
    FunctionGraph& graph = call.x.graph();
    return {graph, graph.crackle(settings, call.x.node(), call.y.node(), call.z.node())};
}

}  // namespace

/// Iterations are unrolled; an orbit that has ended takes the value of its last step and nothing behind it.
Expression fractalPattern(const PatternCall& call) {
    const Pattern& pattern = call.pattern;
    if (pattern.iterations > unrolledIterations) return lookedUp(call);
    const int count = std::max(pattern.iterations, 1);
    const Complex point{call.x, call.y};
    const Complex constant = fractal::isJulia(pattern.kind) ? Complex{call.number(pattern.juliaPoint[0]),
                                                                      call.number(pattern.juliaPoint[1])}
                                                            : point;
    const bool fromZero = fractal::fromZero(pattern.kind);
    Complex u = fromZero ? Complex{call.number(0), call.number(0)} : point;
    Expression least = call.number(0);
    if (!fromZero) least = fractal::squaredSize(u);
    std::vector<Expression> margins, values;
    for (int k = 0; k < count; ++k) {
        u = fractal::step(pattern, u, constant);
        margins.push_back(fractal::margin(pattern, u));
        values.push_back(
            fractal::colored(pattern.exterior, u, call.number(static_cast<double>(k) / count), false));
        least = fromZero && k == 0 ? fractal::squaredSize(u) : min(least, fractal::squaredSize(u));
    }
    Expression value = fractal::colored(pattern.interior, u, sqrt(least) * pattern.interior.factor, true);
    for (std::size_t k = values.size(); k-- > 0;) value = select(margins[k], values[k], value);
    return value;
}

}  // namespace isoscope
