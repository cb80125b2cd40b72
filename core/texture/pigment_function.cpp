// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/pigment_function.h"

#include "core/function/surface_variables.h"
#include "core/image/brightness.h"
#include "core/texture/tables/image_table.h"
#include "core/texture/map_value.h"
#include "core/texture/own_colors.h"
#include "core/texture/surface_needs.h"

namespace isoscope {

namespace {

PatternPoint spacePoint(FunctionGraph& graph) {
    const auto variable = [&](int k) { return Expression(graph, graph.variable(k)); };
    return {variable(0), variable(1), variable(2)};
}

using Entries = std::vector<MappedPigment::Entry>;

ColorExpression constantColor(const Color& color, Expression any) {
    return {any.number(color.red), any.number(color.green), any.number(color.blue), any.number(color.filter),
            any.number(color.transmit)};
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
    const PatternPoint at = patternPoint(pattern, pigment.onSurface ? surfacePoint(point[0].graph()) : point);
    if (pigment.image) {
        const auto channel = [&](ImageChannel which) { return imageValue(pigment.image, which, at); };
        return {channel(ImageChannel::red), channel(ImageChannel::green), channel(ImageChannel::blue),
                channel(ImageChannel::filter), channel(ImageChannel::transmit)};
    }
    const Entries entries = completeEntries(pigment);
    std::vector<double> positions;
    std::vector<ColorExpression> colors;
    for (const MappedPigment::Entry& entry : entries) {
        positions.push_back(entry.position);
        colors.push_back(pigmentColor(entry.pigment, at, settings));
    }
    const Expression value = pigment.kind == MapKind::average
                                 ? point[0].number(0)
                                 : patternValue(pattern, at, settings.noiseGenerator);
    ColorExpression result;
    for (std::size_t channel = 0; channel < result.size(); ++channel) {
        std::vector<Expression> choices;
        for (const ColorExpression& color : colors) choices.push_back(color[channel]);
        result[channel] = mapValue(lookupOf(pigment.kind, pattern), value, positions, choices);
    }
    return result;
}

}  // namespace

ColorExpression pigmentColor(const Pigment& pigment, const PatternPoint& point,
                             const PatternSettings& settings) {
    if (const auto* solid = std::get_if<SolidPigment>(&pigment)) return constantColor(solid->color, point[0]);
    return mappedColor(*std::get<std::shared_ptr<const MappedPigment>>(pigment), point, settings);
}

Expression grayOf(const ColorExpression& color) { return brightness(color[0], color[1], color[2]); }

PatternPoint surfacePoint(FunctionGraph& graph) {
    return {surfaceVariable(graph, surface_variable::place, 0),
            surfaceVariable(graph, surface_variable::place, 1), Expression(graph, graph.constant(0))};
}

Function patternFunction(const Pattern& pattern, const PatternSettings& settings, bool onSurface) {
    FunctionGraph graph;
    Pattern counted = pattern;
    counted.numberOfWaves = settings.numberOfWaves;
    const PatternPoint point = onSurface ? surfacePoint(graph) : spacePoint(graph);
    const Expression value = buildPattern(counted, point[0], point[1], point[2], settings.noiseGenerator);
    if (graph.overflowed()) return {};
    const bool surface = onSurface || needsSurface(pattern);
    return finish(std::move(graph), {value.node()}, surface ? surface_variable::count : 3);
}

Function pigmentFunction(const Pigment& pigment, const PatternSettings& settings) {
    FunctionGraph graph;
    const PatternPoint point = spacePoint(graph);
    const int arguments = needsSurface(pigment) ? surface_variable::count : 3;
    std::vector<NodeId> results;
    if (const auto* mapped = std::get_if<std::shared_ptr<const MappedPigment>>(&pigment);
        mapped && (*mapped)->image) {
        const PatternPoint start = (*mapped)->onSurface ? surfacePoint(graph) : point;
        for (const Expression& place : patternPoint((*mapped)->pattern, start))
            results.push_back(place.node());
        if (graph.overflowed()) return {};
        return finish(std::move(graph), std::move(results), arguments);
    }
    const ColorExpression color = pigmentColor(pigment, point, settings);
    if (graph.overflowed()) return {};
    for (const Expression& channel : color) results.push_back(channel.node());
    return finish(std::move(graph), std::move(results), arguments);
}

}  // namespace isoscope
