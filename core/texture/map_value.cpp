// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/map_value.h"

namespace isoscope {

namespace {

using Positions = std::span<const double>;
using Choices = std::span<const Expression>;

bool same(Expression a, Expression b) { return a.node() == b.node(); }

/// From `low` at position `from` to `high` at position `to`.
Expression between(Expression value, double from, double to, Expression low, Expression high) {
    if (same(low, high) || !(to > from)) return high;
    const FunctionGraph& graph = value.graph();
    if (graph.isConstant(low.node()) && graph.isConstant(high.node())) {
        const double start = graph.value(low.node());
        return start + (graph.value(high.node()) - start) / (to - from) * (value - from);
    }
    const Expression share = (value - from) / (to - from);
    return low * (1 - share) + high * share;
}

Expression blended(Expression value, Positions positions, Choices choices) {
    const std::size_t last = positions.size() - 1;
    const Expression end = choices[last];
    Expression result = end;
    for (std::size_t k = positions.size(); k-- > 0;) {
        const Expression here =
            k == 0 ? choices[0] : between(value, positions[k - 1], positions[k], choices[k - 1], choices[k]);
        if (k == last || same(here, result))
            result = here;
        else
            result = select(positions[k] - value, result, here);
    }
    return same(result, end) ? end : select(value - positions[last], result, end);
}

Expression listed(Expression value, Choices choices) {
    Expression result = choices.back();
    for (std::size_t k = choices.size() - 1; k-- > 0;)
        if (!same(result, choices[k]))
            result = select(value - (static_cast<double>(k) + 0.5), choices[k], result);
    return result;
}

Expression averaged(Positions weights, Choices choices) {
    Expression sum = choices[0] * weights[0];
    double total = weights[0];
    for (std::size_t k = 1; k < weights.size(); ++k) {
        sum = sum + choices[k] * weights[k];
        total += weights[k];
    }
    return total == 0 ? sum : sum / total;
}

}  // namespace

MapKind lookupOf(MapKind kind, const Pattern& pattern) {
    return kind == MapKind::list && !keepsWholeNumbers(pattern) ? MapKind::blend : kind;
}

Expression mapValue(MapKind kind, Expression value, Positions positions, Choices choices) {
    switch (kind) {
        case MapKind::average: return averaged(positions, choices);
        case MapKind::list: return listed(value, choices);
        default: return blended(value, positions, choices);
    }
}

}  // namespace isoscope
