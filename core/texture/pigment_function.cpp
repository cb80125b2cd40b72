// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/pigment_function.h"

#include "core/texture/own_colors.h"

namespace isoscope {

namespace {

using Entries = std::vector<MappedPigment::Entry>;

ColorExpression constantColor(const Color& color, Expression any) {
    return {any.number(color.red), any.number(color.green), any.number(color.blue), any.number(color.filter),
            any.number(color.transmit)};
}

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

/// The entries need not be in order: POV-Ray looks at the last one first, then for the first one that is not
/// below the value.
Expression blended(Expression value, const Entries& entries, const std::vector<ColorExpression>& colors,
                   std::size_t channel) {
    const std::size_t last = entries.size() - 1;
    Expression result = colors[last][channel];
    const Expression end = result;
    for (std::size_t k = entries.size(); k-- > 0;) {
        const Expression here = k == 0 ? colors[0][channel]
                                       : between(value, entries[k - 1].position, entries[k].position,
                                                 colors[k - 1][channel], colors[k][channel]);
        if (k == last || same(here, result))
            result = here;
        else
            result = select(entries[k].position - value, result, here);
    }
    return same(result, end) ? end : select(value - entries[last].position, result, end);
}

Expression listed(Expression value, const std::vector<ColorExpression>& colors, std::size_t channel) {
    Expression result = colors.back()[channel];
    for (std::size_t k = colors.size() - 1; k-- > 0;)
        if (!same(result, colors[k][channel]))
            result = select(value - (static_cast<double>(k) + 0.5), colors[k][channel], result);
    return result;
}

Expression averaged(const Entries& entries, const std::vector<ColorExpression>& colors, std::size_t channel) {
    Expression sum = colors[0][channel] * entries[0].position;
    double total = entries[0].position;
    for (std::size_t k = 1; k < entries.size(); ++k) {
        sum = sum + colors[k][channel] * entries[k].position;
        total += entries[k].position;
    }
    return total == 0 ? sum : sum / total;
}

Entries completeEntries(const MappedPigment& pigment) {
    if (pigment.kind != MapKind::list)
        return pigment.entries.empty() ? ownColors(pigment.pattern.kind) : pigment.entries;
    // A list that is too short goes on with the pattern's own colours.
    Entries entries = ownColors(pigment.pattern.kind);
    for (std::size_t k = 0; k < pigment.entries.size(); ++k)
        if (k < entries.size())
            entries[k] = pigment.entries[k];
        else
            entries.push_back(pigment.entries[k]);
    return entries;
}

ColorExpression mappedColor(const MappedPigment& pigment, const PatternPoint& point,
                            const PatternSettings& settings) {
    Pattern pattern = pigment.pattern;
    pattern.numberOfWaves = settings.numberOfWaves;
    const PatternPoint at = patternPoint(pattern, point);
    const Entries entries = completeEntries(pigment);
    std::vector<ColorExpression> colors;
    for (const MappedPigment::Entry& entry : entries)
        colors.push_back(pigmentColor(entry.pigment, at, settings));
    const bool isAverage = pigment.kind == MapKind::average;
    const Expression value =
        isAverage ? point[0].number(0) : patternValue(pattern, at, settings.noiseGenerator);
    ColorExpression result;
    for (std::size_t channel = 0; channel < result.size(); ++channel)
        result[channel] = isAverage                       ? averaged(entries, colors, channel)
                          : pigment.kind == MapKind::list ? listed(value, colors, channel)
                                                          : blended(value, entries, colors, channel);
    return result;
}

}  // namespace

ColorExpression pigmentColor(const Pigment& pigment, const PatternPoint& point,
                             const PatternSettings& settings) {
    if (const auto* solid = std::get_if<SolidPigment>(&pigment)) return constantColor(solid->color, point[0]);
    return mappedColor(*std::get<std::shared_ptr<const MappedPigment>>(pigment), point, settings);
}

Expression grayOf(const ColorExpression& color) {
    return 0.297 * color[0] + 0.589 * color[1] + 0.114 * color[2];
}

Function pigmentFunction(const Pigment& pigment, const PatternSettings& settings) {
    FunctionGraph graph;
    const PatternPoint point{Expression(graph, graph.variable(0)), Expression(graph, graph.variable(1)),
                             Expression(graph, graph.variable(2))};
    const ColorExpression color = pigmentColor(pigment, point, settings);
    if (graph.overflowed()) return {};
    std::vector<NodeId> results;
    for (const Expression& channel : color) results.push_back(channel.node());
    return finish(std::move(graph), std::move(results), 3);
}

}  // namespace isoscope
