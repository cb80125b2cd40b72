// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/function/derivative.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/function/graph_builder.h"
#include "core/function/graph_copy.h"

namespace isoscope {

namespace {

/// A value that may be missing: a derivative of 0, so that no terms of 0 are written.
using Slope = std::optional<Expression>;

Slope plus(const Slope& a, const Slope& b) { return a && b ? Slope(*a + *b) : a ? a : b; }
Slope minus(const Slope& a, const Slope& b) {
    return a && b ? Slope(*a - *b) : a ? a : b ? Slope(-*b) : Slope();
}
Slope times(const Slope& a, const Expression& factor) { return a ? Slope(*a * factor) : Slope(); }
Slope over(const Slope& a, const Expression& divisor) { return a ? Slope(*a / divisor) : Slope(); }

/// The slope of one side or the other.
Slope chosen(const Expression& sign, const Slope& negative, const Slope& otherwise) {
    if (!negative && !otherwise) return {};
    const Expression zero = sign.number(0);
    return select(sign, negative.value_or(zero), otherwise.value_or(zero));
}

/// Of the lesser of u and v: v also where one is undefined, as minimum has it.
Slope lesserSlope(const Expression& u, const Expression& v, const Slope& du, const Slope& dv) {
    if (!du && !dv) return {};
    const Expression zero = u.number(0), first = du.value_or(zero);
    return select(u - v, first, first, dv.value_or(zero));
}

/// Of an operation of one operand `u`, whose slope is `d` and whose value is `v`.
Slope unarySlope(Operation operation, const Expression& u, const Expression& v, const Slope& d) {
    if (!d) return {};
    using enum Operation;
    switch (operation) {
        case negate: return -*d;
        case absolute: return chosen(u, -*d, d);
        case square: return times(d, 2 * u);
        case squareRoot: return over(d, 2 * v);
        case exponential: return times(d, v);
        case naturalLogarithm: return over(d, u);
        case decimalLogarithm: return over(d, u * std::log(10.0));
        case sine: return times(d, cos(u));
        case cosine: return times(d, -sin(u));
        case tangent: return times(d, 1 + sq(v));
        case arcSine: return over(d, sqrt(1 - sq(u)));
        case arcCosine: return over(d, -sqrt(1 - sq(u)));
        case arcTangent: return over(d, 1 + sq(u));
        case hyperbolicSine: return times(d, apply(hyperbolicCosine, u));
        case hyperbolicCosine: return times(d, apply(hyperbolicSine, u));
        case hyperbolicTangent: return times(d, 1 - sq(v));
        case areaSine: return over(d, sqrt(sq(u) + 1));
        case areaCosine: return over(d, sqrt(sq(u) - 1));
        case areaTangent: return over(d, 1 - sq(u));
        case fraction: return d;
        case triangleWave: return times(d, select(apply(fraction, u) - 0.5, u.number(2), u.number(-2)));
        case cycle: return times(d, 2 * M_PI * cos(2 * M_PI * u));
        default: return {};  // floor, ceiling, truncate
    }
}

/// base to the power of exponent, with their slopes.
Slope powerSlope(const Expression& u, const Expression& v, const Expression& whole, const Slope& du,
                 const Slope& dv) {
    Slope byBase;
    if (du) byBase = times(du, v * pow(u, v - 1));
    Slope byExponent;
    if (dv) byExponent = times(dv, whole * apply(Operation::naturalLogarithm, u));
    return plus(byBase, byExponent);
}

Slope binarySlope(Operation operation, const Expression& u, const Expression& v, const Expression& whole,
                  const Slope& du, const Slope& dv) {
    using enum Operation;
    switch (operation) {
        case add: return plus(du, dv);
        case subtract: return minus(du, dv);
        case multiply: return plus(times(du, v), times(dv, u));
        case divide: return over(minus(du, times(dv, whole)), v);
        case power: return powerSlope(u, v, whole, du, dv);
        case arcTangent2: return du || dv ? over(minus(times(du, v), times(dv, u)), sq(u) + sq(v)) : Slope();
        case remainder: return minus(du, times(dv, apply(truncate, u / v)));
        case minimum: return lesserSlope(u, v, du, dv);
        case maximum: return chosen(u - v, dv, du);
        default: return {};  // div, comparisons, logic
    }
}

}  // namespace

GradientFunction gradientOf(const Function& function) {
    if (!function.valid()) return {};
    FunctionGraph graph;
    GraphCopy copy;
    copy.variable = [&](std::uint32_t index) { return graph.variable(static_cast<int>(index)); };
    const NodeId whole = copy.into(graph, function);
    if (graph.overflowed()) return {};
    const std::vector<bool> needed = neededNodes(graph, whole);
    std::vector<std::array<Slope, 3>> slopes(whole + 1);
    for (NodeId id = 0; id <= whole && !graph.overflowed(); ++id) {
        if (!needed[id]) continue;
        // By value: the graph grows.
        const Node node = graph[id];
        const auto value = [&](std::size_t k) { return Expression(graph, node.operands[k]); };
        const bool moves = std::ranges::any_of(graph.operandsOf(id), [&](NodeId operand) {
            return std::ranges::any_of(slopes[operand], [](const Slope& one) { return one.has_value(); });
        });
        if (node.operation == Operation::variable) {
            if (node.index < 3) slopes[id][node.index] = Expression(graph, graph.constant(1));
            continue;
        }
        if (!moves) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto slope = [&](std::size_t i) { return slopes[node.operands[i]][k]; };
            const Expression result(graph, id);
            if (node.operation == Operation::select3)
                slopes[id][k] = chosen(value(0), slope(1), slope(2));
            else if (node.operation == Operation::select4) {
                const Expression zero(graph, graph.constant(0));
                if (slope(1) || slope(2) || slope(3))
                    slopes[id][k] = select(value(0), slope(1).value_or(zero), slope(2).value_or(zero),
                                           slope(3).value_or(zero));
            } else if (arity(node.operation) == 1)
                slopes[id][k] = unarySlope(node.operation, value(0), result, slope(0));
            else if (arity(node.operation) == 2)
                slopes[id][k] = binarySlope(node.operation, value(0), value(1), result, slope(0), slope(1));
            else
                return {{}, node.operation};
        }
    }
    std::vector<NodeId> results{whole};
    for (std::size_t k = 0; k < 3; ++k)
        results.push_back(slopes[whole][k] ? slopes[whole][k]->node() : graph.constant(0));
    if (graph.overflowed()) return {};
    return {finish(std::move(graph), std::move(results), function.argumentCount), {}};
}

}  // namespace isoscope
